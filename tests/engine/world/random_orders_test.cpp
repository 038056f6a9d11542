// Property: whatever orders are given in whatever scene, no number breaks, nobody enters another or is lost,
// and a world that is restored or rewound goes on bit for bit.
#include <doctest.h>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

Order randomOrder(Random& random, const World& world) {
    const auto place = [&] { return Vec2{random.uniform(-13, 13), random.uniform(-13, 13)}; };
    Order order;
    order.kind = static_cast<OrderKind>(random.below(4));
    order.target = place();
    if (random.below(2) == 0) order.facing = random.uniform(-4, 4);
    if (random.below(4) == 0) order.width = random.uniform(1, 8);
    for (std::uint32_t k = random.below(6); k > 3; --k) order.route.push_back(place());
    if (random.below(5) == 0) {
        order.formation.emplace();
        order.formation->kind = static_cast<FormationKind>(random.below(8));
    }
    order.manner = static_cast<Manner>(random.below(2));
    order.turn = static_cast<Turn>(random.below(3));
    order.pace = random.below(3) == 0 ? random.uniform(0.2, 4) : 0.0;
    order.share = random.uniform(0.3, 1.0);
    if (order.kind == OrderKind::Face) order.facing = random.uniform(-4, 4);
    if (order.kind == OrderKind::Guard) order.halfSize = {random.uniform(0, 4), random.uniform(0, 4)};
    if (order.kind == OrderKind::Follow) order.group = world.group(random.below(2)).id;
    order.offset = {random.uniform(-3, 3), random.uniform(-3, 3)};
    return order;
}

/// Gives orders and edits queues at random: one call per step.
struct Commander {
    Random random;

    void operator()(World& world) {
        const std::uint32_t dice = random.below(60);
        const GroupId group = world.group(random.below(2)).id;
        if (dice < 4) {
            GiveOrder given{group, static_cast<QueueMode>(random.below(3)), random.below(3), {}};
            given.order = randomOrder(random, world);
            (void)give(world, given);
        } else if (dice == 10) {
            (void)give(world, EditQueue{group, static_cast<QueueEdit>(random.below(6))});
        } else if (dice == 20) {
            Conduct conduct{.squeeze = random.uniform(0, 1), .avoids = random.below(4) > 0};
            (void)give(world, ChangeGroup{.group = group, .conduct = conduct});
        } else if (dice == 30 && !world.obstacleIds().empty()) {
            (void)give(world, removeThing(world.obstacleIds().back()));
        } else if (dice == 40) {
            (void)give(world, putThing(tree({random.uniform(-9, 9), random.uniform(-9, 9)}, 0.3)));
        } else if (dice == 50) {
            (void)give(world, SetPose{group, {random.uniform(-9, 9), random.uniform(-9, 9)}, 1.0});
        }
    }
};

}  // namespace

TEST_CASE("random orders keep every invariant") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        World world = World::create(busyFloor(seed)).value();
        const std::size_t count = world.characters().size();
        Commander commander{Random(seed * 31)};
        int leaving = 0;
        for (int s = 0; s < 600; ++s) {
            const std::size_t obstacles = world.obstacleIds().size();
            commander(world);
            world.step();
            leaving = world.obstacleIds().size() > obstacles ? 120 : leaving - 1;
            const CharactersView c = world.characters();
            REQUIRE(c.size() == count);
            for (std::size_t i = 0; i < c.size(); ++i) {
                REQUIRE(isFinite(c.position[i]));
                REQUIRE(isFinite(c.velocity[i]));
                REQUIRE(inspect::environment(world).def().box.contains(c.position[i]));
            }
            if (leaving <= 0) REQUIRE(world.contacts().overlapPairs == 0);
            for (std::size_t g = 0; g < world.groupCount(); ++g)
                for (const Vec2 v : world.group(g).finalMesh) REQUIRE(isFinite(v));
        }
    }
}

TEST_CASE("restored or rewound amid orders, a world goes on bit for bit") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        CAPTURE(seed);
        World world = World::create(busyFloor(seed)).value();
        Commander commander{Random(seed * 17)};
        for (std::uint32_t s = 0; s < 100 + 37 * seed; ++s) {
            commander(world);
            world.step();
        }
        checkGoesOn(world, 120, commander);
    }
}

TEST_CASE("a snapshot in the midst of a search for a way goes on bit for bit") {
    WorldDef def{.box = {{-100, -100}, {100, 100}}, .cell = 0.5};
    Random random(4);
    for (int k = 0; k < 150; ++k)
        def.obstacles.push_back(
            tree({random.uniform(-90, 90), random.uniform(-90, 90)}, random.uniform(1, 4)));
    def.groups.push_back({.count = 40, .position = {-95, -95}, .orders = {Order::move({95, 95})}});
    World world = World::create(def).value();
    for (int s = 0; s < 3; ++s) world.step();
    checkGoesOn(world, 100);
    CHECK_FALSE(world.group(0).way.empty());
}
