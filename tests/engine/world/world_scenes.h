// Small worlds that the world's tests share.
#pragma once

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/random.h"
#include "muster/world.h"

namespace muster::testing {

/// An open floor of 24 m with one square group of `count` at the left.
inline WorldDef openFloor(std::int32_t count = 25) {
    return {.box = {{-12, -12}, {12, 12}}, .groups = {{.count = count, .position = {-6, 0}}}};
}

/// So many seconds of steps.
inline void run(World& world, double seconds) {
    const long steps = std::lround(seconds / world.parameters().stepTime);
    for (long s = 0; s < steps; ++s) world.step();
}

/// A copy of what a view shows, to compare with later.
template <class T>
std::vector<T> copyOf(std::span<const T> values) {
    return {values.begin(), values.end()};
}

/// The mean position of the members of a group [m].
inline Vec2 middleOf(const World& world, std::size_t group = 0) {
    Vec2 sum;
    const GroupView view = world.group(group);
    for (const std::int32_t i : view.members) sum += world.characters().position[i];
    return sum / static_cast<double>(view.members.size());
}

/// The farthest that a matched character is from its place: of one group, or of all [m].
inline double worstToPlace(const World& world, std::optional<std::size_t> group = {}) {
    double worst = 0.0;
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.place[i] < 0 || (group && c.group[i] != *group)) continue;
        worst = std::max(worst, distance(c.position[i], world.group(c.group[i]).placePositions[c.place[i]]));
    }
    return worst;
}

inline ObstacleDef block(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

inline ObstacleDef tree(Vec2 centre, double radius) {
    return {.centre = centre, .radius = radius};
}

inline PatchDef rectangle(double x0, double y0, double x1, double y1, MotionId motion) {
    return {.name = "patch", .polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .motion = motion};
}

/// A floor with a block, trees, a moving car, patches and two groups, chosen by `seed`.
inline WorldDef busyFloor(std::uint64_t seed) {
    Random random(seed);
    WorldDef def = openFloor(16 + static_cast<std::int32_t>(random.below(20)));
    def.seed = seed;
    def.obstacles.push_back(block(-1, -3, 1, random.uniform(0, 3)));
    for (int i = 0; i < 5; ++i)
        def.obstacles.push_back(tree({random.uniform(2, 10), -9 + 4.0 * i}, random.uniform(0.2, 0.7)));
    ObstacleDef car = tree({0, 8}, 0.8);
    car.path.waypoints = {{0, {0, 0}, 0}, {4, {6, 0}, 0}, {8, {0, 0}, 0}};
    car.path.loop = true;
    def.obstacles.push_back(car);
    def.patches.push_back(rectangle(-4, -10, 4, -6, 3));
    def.patches.push_back(rectangle(3, 5, 4, 8, 6));
    def.groups.push_back({.count = 9, .formation = {.kind = FormationKind::Ring}, .position = {6, 9}});
    def.groups[0].jitter = 0.1;
    return def;
}

/// Submits a command of client 1 for the coming step, after those that it has submitted for it before.
inline Status give(World& world, CommandBody body) {
    return world.submit({world.stepCount(), 1, 0, std::move(body)});
}

/// Gives a group an order in place of those that it has.
inline void tell(World& world, const Order& order, GroupId group) {
    REQUIRE(give(world, GiveOrder{group, QueueMode::Replace, 0, order}).ok());
}
inline void tell(World& world, const Order& order, std::size_t group = 0) {
    tell(world, order, world.group(group).id);
}

/// Steps a world and a copy of it that is restored with two threads, then the world once more from the same
/// step, rewound, and checks that all three go through the same states. Before each step they are told the
/// same: every one has its own `director`.
template <class Director = void (*)(World&)>
void checkGoesOn(
    World& world, int steps, Director director = [](World&) {}) {
    const std::vector<std::uint8_t> saved = world.snapshot();
    Result<World> copy = World::restore(saved, 2);
    REQUIRE_MESSAGE(copy.ok(), copy.status().message());
    CHECK(copy->snapshot() == saved);
    Director other = director, again = director;
    std::vector<std::uint64_t> hashes;
    for (int s = 0; s < steps; ++s) {
        director(world);
        other(*copy);
        world.step();
        copy->step();
        hashes.push_back(world.hash());
        REQUIRE(copy->hash() == hashes.back());
    }
    REQUIRE(world.rewind(saved).ok());
    for (int s = 0; s < steps; ++s) {
        again(world);
        world.step();
        REQUIRE(world.hash() == hashes[s]);
    }
}

/// Touches, drags and lifts at random, changes formations, edits the ground: one call per step.
class RandomDirector {
public:
    explicit RandomDirector(std::uint64_t seed) : random_(seed) {}

    void operator()(World& world) { act(world); }
    void act(World& world) {
        const std::uint32_t dice = random_.below(100);
        const double now = world.time();
        if (dice < 4) begin(world, now);
        for (std::uint32_t touch = 1; touch <= down_; ++touch) {
            positions_[touch] += Vec2{random_.uniform(-0.1, 0.2), random_.uniform(-0.1, 0.1)};
            (void)give(world, Touch{TouchPhase::Move, touch, positions_[touch], now, {}});
        }
        if (dice == 50) {
            for (std::uint32_t touch = 1; touch <= down_; ++touch)
                (void)give(world, Touch{TouchPhase::Up, touch, {}, now, {}});
            down_ = 0;
        }
        if (dice == 60) {
            FormationDef formation{.kind = static_cast<FormationKind>(random_.below(8))};
            (void)give(world, ChangeGroup{.group = world.group(0).id, .formation = formation});
        }
        if (dice == 70)
            (void)give(world, putThing(tree({random_.uniform(-9, 9), random_.uniform(-9, 9)}, 0.4)));
        if (dice == 80 && !world.obstacleIds().empty())
            (void)give(world, removeThing(world.obstacleIds().back()));
        if (dice == 90)
            (void)give(world, ChangeGroup{.group = world.group(0).id,
                                          .count = static_cast<std::int32_t>(10 + random_.below(30))});
    }

    template <class Archive>
    void visit(Archive& archive) {
        archive(random_, down_, positions_);
    }

private:
    void begin(World& world, double now) {
        if (down_ >= 3) return;
        const auto mesh = world.group(0).finalMesh;
        const std::uint32_t touch = ++down_;
        positions_[touch] = mesh[random_.below(static_cast<std::uint32_t>(mesh.size()))];
        (void)give(world, Touch{TouchPhase::Down, touch, positions_[touch], now, world.group(0).id});
    }

    Random random_;
    std::uint32_t down_ = 0;
    std::array<Vec2, 4> positions_{};
};

/// Eight people before a wall of 1 m with doors of 0.8 and 1.2 m, and one who stands in the first of them.
inline WorldDef twoDoors(Stance stance) {
    WorldDef def{
        .box = {{-20, -15}, {20, 15}},
        .obstacles = {block(-0.5, -15, 0.5, -8.6), block(-0.5, -7.4, 0.5, -0.4), block(-0.5, 0.4, 0.5, 15)}};
    GroupDef group{.count = 8, .formation = {.files = 2}, .position = {-9, 0}};
    def.groups.push_back(group);
    group.count = 1;
    group.position = {0, 0};
    group.conduct.stance = stance;
    def.groups.push_back(group);
    return def;
}

}  // namespace muster::testing
