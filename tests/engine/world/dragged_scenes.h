// Random scenes in which fingers drag groups across obstacles, and an oracle of the room that was left.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "base/maths.h"
#include "base/random.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/metrics.h"
#include "muster/world.h"

namespace muster::testing {

/// What is dragged across what.
enum class SceneFamily {
    Sparse,   ///< One group, 4 to 25 obstacles of 0.4 to 4 m.
    Dense,    ///< One group, 25 to 70 obstacles of 0.3 to 1.8 m.
    Crossing  ///< Two groups whose ways cross at a right angle, 4 to 25 obstacles of 0.4 to 4 m.
};

/// A world of 60 m, and the fingers that drag the corners of each group over 36 m.
class DraggedScene {
public:
    DraggedScene(SceneFamily family, std::uint64_t seed)
        : random_(2 * seed + 1000003 * static_cast<std::uint64_t>(family)) {
        def_.box = {{-30, -30}, {30, 30}};
        def_.seed = seed;
        addGroup({-18, 0}, {1, 0}, family == SceneFamily::Crossing ? 144 : 256);
        if (family == SceneFamily::Crossing) addGroup({0, -18}, {0, 1}, 144);
        const bool dense = family == SceneFamily::Dense;
        const std::uint32_t count = dense ? 25 + random_.below(46) : 4 + random_.below(22);
        while (def_.obstacles.size() < count) addObstacle(dense ? 0.3 : 0.4, dense ? 1.8 : 4.0);
    }

    const WorldDef& def() const { return def_; }
    /// The time of the last command [s].
    static constexpr double end() { return kStart + kDrawing; }

    /// Submits the commands of the coming step.
    void act(World& world) {
        const double now = world.time();
        if (down_ == 0 && now >= kStart) begin(world);
        if (down_ == 0 || lifted_) return;
        const double share = std::min(1.0, (now - kStart) / kDrawing);
        if (world.stepCount() % 4 == 0 || share >= 1.0)
            for (std::uint32_t touch = 1; touch <= down_; ++touch)
                give(world, Touch{TouchPhase::Move,
                                  touch,
                                  corners_[touch - 1] + drag_[(touch - 1) / 4] * share,
                                  now,
                                  {}});
        if (share < 1.0) return;
        for (std::uint32_t touch = 1; touch <= down_; ++touch)
            give(world, Touch{TouchPhase::Up, touch, {}, now, {}});
        lifted_ = true;
    }

private:
    static constexpr double kStart = 0.5, kDrawing = 8.0, kWay = 36.0;  // [s], [s], [m]

    template <class Body>
    void give(World& world, Body body) {
        const Status status = world.submit({world.stepCount(), 1, sequence_++, body});
        MUSTER_ASSERT(status.ok());
        (void)status;
    }

    void addGroup(Vec2 centre, Vec2 forward, std::uint32_t most) {
        GroupDef group{.count = static_cast<std::int32_t>(9 + random_.below(most - 8)),
                       .formation = {.spacing = random_.uniform(0.8, 1.2)},
                       .position = centre};
        def_.groups.push_back(group);
        drag_.push_back(forward * kWay);
        const double half = 0.5 * group.formation.spacing * std::ceil(std::sqrt(group.count));
        starts_.push_back(Box{centre - Vec2{half, half}, centre + Vec2{half, half}}.grown(1.0));
    }

    // Obstacles may touch each other, but no start.
    void addObstacle(double least, double most) {
        const double radius = 0.5 * random_.uniform(least, most);
        // Half of them lie about a goal, the others anywhere on a way.
        const std::size_t group = random_.below(static_cast<std::uint32_t>(starts_.size()));
        const double back = random_.below(2) == 0 ? 1.0 : random_.uniform();
        const Box area = starts_[group].grown(3.0);
        const Vec2 centre = Vec2{random_.uniform(area.min.x, area.max.x),
                                 random_.uniform(area.min.y, area.max.y)} +
                            drag_[group] * back;
        ObstacleDef obstacle;
        if (random_.below(2) == 0) {
            obstacle.centre = centre;
            obstacle.radius = radius;
        } else {
            const std::uint32_t corners = 3 + random_.below(5);
            const double turn = random_.uniform(0.0, 2.0 * kPi);
            // Corners on a circle in ascending order of angle are convex.
            for (std::uint32_t k = 0; k < corners; ++k) {
                const double angle = turn + 2.0 * kPi * (k + random_.uniform(0.0, 0.9)) / corners;
                obstacle.polygon.push_back(centre + Vec2{cosine(angle), sine(angle)} * radius);
            }
        }
        if (!def_.box.contains(centre)) return;
        for (const Box& start : starts_)
            if (start.grown(radius).contains(centre)) return;
        def_.obstacles.push_back(obstacle);
    }

    void begin(World& world) {
        for (std::size_t g = 0; g < world.groupCount(); ++g) {
            const GroupView group = world.group(g);
            for (const Vec2 way : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
                Vec2 corner = group.finalMesh[0];
                for (const Vec2 v : group.finalMesh)
                    if (dot(v - corner, way) > 0.0) corner = v;
                corners_.push_back(corner);
                give(world, Touch{TouchPhase::Down, ++down_, corner, world.time(), group.id});
            }
        }
    }

    Random random_;
    WorldDef def_;
    std::vector<Vec2> drag_;  // Of each group [m].
    std::vector<Box> starts_;
    std::vector<Vec2> corners_;
    std::uint32_t down_ = 0, sequence_ = 0;
    bool lifted_ = false;
};

/// True where another character could stand near the formation of the group: some point within 8 diameters of
/// a place is clear of obstacles and of all who stand, and joined to the group by free cells of 0.1 m.
inline bool roomIsLeft(const World& world, std::size_t index) {
    const Environment& environment = inspect::environment(world);
    const double radius = world.parameters().character.radius + world.parameters().place.clearance;
    const GroupView group = world.group(index);
    const CharactersView c = world.characters();
    const Box box = environment.def().box;
    constexpr double kCell = 0.1;
    const auto width = static_cast<std::int32_t>((box.max.x - box.min.x) / kCell);
    const auto centre = [&](std::int32_t x, std::int32_t y) {
        return box.min + Vec2{x + 0.5, y + 0.5} * kCell;
    };
    std::vector<std::uint8_t> seen(static_cast<std::size_t>(width) * width, 0);
    std::vector<std::int32_t> open;
    const auto reach = [&](std::int32_t x, std::int32_t y) {
        if (x < 0 || y < 0 || x >= width || y >= width || seen[y * width + x] != 0) return;
        seen[y * width + x] = 1;
        if (box.grown(-radius).contains(centre(x, y)) &&
            environment.distanceToObstacle(centre(x, y)) >= radius + 0.5 * kCell)
            open.push_back(y * width + x);
    };
    const Vec2 first = (c.position[group.members[0]] - box.min) * (1.0 / kCell);
    reach(static_cast<std::int32_t>(first.x), static_cast<std::int32_t>(first.y));
    while (!open.empty()) {
        const std::int32_t x = open.back() % width, y = open.back() / width;
        open.pop_back();
        const Vec2 p = centre(x, y);
        double place = 1e9, standing = 1e9;
        for (const Vec2 q : group.placePositions) place = std::min(place, distance(p, q));
        for (std::size_t i = 0; i < c.size(); ++i)
            if (c.place[i] >= 0) standing = std::min(standing, distance(p, c.position[i]));
        if (place < 16 * radius && standing >= 2.0 * radius) return true;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) reach(x + dx, y + dy);
    }
    return false;
}

/// How a scene ended.
struct SceneOutcome {
    RunFigures figures;
    std::int32_t notArrived = 0;  ///< At most 60 s after the last command, without those who had no room.
};

/// Plays a scene until all have arrived, or for 60 s after the last command.
inline SceneOutcome play(SceneFamily family, std::uint64_t seed) {
    DraggedScene scene(family, seed);
    World world = World::create(scene.def()).value();
    RunMetrics metrics(world);
    while (world.time() < DraggedScene::end() + 60.0) {
        scene.act(world);
        world.step();
        metrics.observe(world);
        if (world.time() > DraggedScene::end() && world.stepCount() % 30 == 0 && metrics.settled(world))
            break;
    }
    SceneOutcome outcome{.figures = metrics.figures(world, false), .notArrived = metrics.notArrived(world)};
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        std::int32_t unmatched = 0;
        for (const std::int32_t i : world.group(g).members)
            unmatched += world.characters().place[i] < 0 ? 1 : 0;
        if (unmatched > 0 && !roomIsLeft(world, g)) outcome.notArrived -= unmatched;
    }
    return outcome;
}

}  // namespace muster::testing
