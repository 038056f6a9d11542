// Obstacles whose paths are over: what will never move again is ground.
#include <doctest.h>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A wall at x = 0 with a door at y = 0 and, where `other`, one at y = 12; something slides into the first
/// door between 2 and 4 s and stays.
WorldDef twoDoors(bool other) {
    WorldDef def = openFloor(20);
    def.box = {{-30, -25}, {30, 25}};
    def.groups[0].position = {-16, 0};
    const double top = other ? 11.0 : 25.0;
    def.obstacles.push_back({.polygon = {{-0.5, -25}, {0.5, -25}, {0.5, -1.5}, {-0.5, -1.5}}});
    def.obstacles.push_back({.polygon = {{-0.5, 1.5}, {0.5, 1.5}, {0.5, top}, {-0.5, top}}});
    if (other) def.obstacles.push_back({.polygon = {{-0.5, 13}, {0.5, 13}, {0.5, 25}, {-0.5, 25}}});
    def.obstacles.push_back({.polygon = {{-0.4, -4.8}, {0.4, -4.8}, {0.4, -1.6}, {-0.4, -1.6}},
                             .path = {.waypoints = {{2.0, {0, 0}}, {4.0, {0, 3.2}}}}});
    return def;
}

void sendAcross(World& world) {
    REQUIRE(world.submit({0, 1, 0, GiveOrder{world.group(0).id, QueueMode::Replace, 0, Order::move({16, 0})}})
                .ok());
}

std::size_t beyond(const World& world) {
    std::size_t count = 0;
    for (const Vec2 p : world.characters().position) count += p.x > 10.0 ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("a gate that has shut for good is ground: all go through the other door, and change few places") {
    World world = World::create(twoDoors(true)).value();
    sendAcross(world);
    std::size_t swaps = 0;
    for (int s = 0; s < 40 * 60; ++s) {
        world.step();
        for (const Event& event : world.events()) swaps += event.kind == EventKind::Swap ? 1 : 0;
    }
    CHECK(beyond(world) == 20);
    CHECK(swaps < 10 * 20);
}

TEST_CASE("where the only gate has shut for good people hear that there is no way") {
    World world = World::create(twoDoors(false)).value();
    sendAcross(world);
    double heard = 0.0;
    for (int s = 0; s < 20 * 60; ++s) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::NoPath && heard == 0.0) heard = world.time();
    }
    CHECK(heard > 3.9);
    CHECK(heard < 4.2);
}

TEST_CASE("what stands for ever by its path is ground from the first step, as if it had none") {
    WorldDef def = twoDoors(true);
    ObstacleDef& gate = def.obstacles.back();
    for (Vec2& p : gate.polygon) p.y += 3.2;
    gate.path = {};
    World plain = World::create(def).value();
    gate.path.waypoints = {{0.0, {}}, {1000.0, {}}};
    World standing = World::create(def).value();
    sendAcross(plain);
    sendAcross(standing);
    run(plain, 20.0);
    run(standing, 20.0);
    for (std::size_t i = 0; i < plain.characters().size(); ++i)
        CHECK(plain.characters().position[i] == standing.characters().position[i]);
}

TEST_CASE("a world rewound to before its gate has shut goes the same way again") {
    World world = World::create(twoDoors(true)).value();
    sendAcross(world);
    run(world, 3.0);
    const std::vector<std::uint8_t> before = world.snapshot();
    run(world, 9.0);
    const std::uint64_t hash = world.hash();
    REQUIRE(world.rewind(before).ok());
    run(world, 9.0);
    CHECK(world.hash() == hash);
}
