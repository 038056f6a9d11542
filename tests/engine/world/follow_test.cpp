// Groups that follow another one among walls: their places lie on the way, not behind walls.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Four groups of six in a row, before a street of 2.6 m with three corners.
WorldDef streetOfCorners() {
    WorldDef def{
        .box = {{-30, -20}, {40, 20}},
        .obstacles = {block(0, 1.3, 8.7, 20), block(0, -20, 18.7, -1.3), block(11.3, -1.3, 18.7, 6.7),
                      block(8.7, 9.3, 21.3, 20), block(21.3, -6, 21.6, 20)}};
    GroupDef group{.count = 6};
    for (int k = 0; k < 4; ++k) {
        group.position = {-6.0 - 4.0 * k, 0};
        def.groups.push_back(group);
    }
    return def;
}

}  // namespace

TEST_CASE("three groups follow a fourth round the corners of a street, each behind the one before") {
    WorldDef def = streetOfCorners();
    World world = World::create(def).value();
    tell(world, Order::move({30, -12}));
    for (std::size_t g = 1; g < 4; ++g) tell(world, Order::follow(world.group(g - 1).id, {-4, 0}), g);
    double arrived = 0.0;
    while (world.time() < 60.0) {
        world.step();
        if (arrived == 0.0 && world.group(0).orders.empty()) arrived = world.time();
        if (arrived > 0.0 && world.time() > arrived + 8.0) break;
    }
    // 64 m at 1.94 m/s, as far as the street lets six go side by side.
    CHECK(arrived > 0.0);
    CHECK(arrived < 45.0);
    for (std::size_t g = 1; g < 4; ++g)
        for (const std::int32_t i : world.group(g).members) {
            CAPTURE(g);
            CHECK(world.characters().position[i].x > 19.0);
            CHECK(length(world.characters().velocity[i]) < 0.3);
        }
}

TEST_CASE("who follows a single one beside a wall has no place behind the wall") {
    WorldDef def{.box = {{-20, -10}, {20, 10}}, .obstacles = {block(-15, 1.0, 15, 1.3)}};
    GroupDef group{.count = 1, .position = {-12, 0}};
    def.groups.push_back(group);
    group.count = 4;
    group.position = {-16, -2};
    def.groups.push_back(group);
    World world = World::create(def).value();
    tell(world, Order::move({10, 0}));
    // To the left of who it follows, which is the other side of the wall.
    tell(world, Order::follow(world.group(0).id, {0, 4}), 1);
    while (world.time() < 25.0) {
        world.step();
        if (world.time() < 5.0) continue;
        for (const std::int32_t i : world.group(1).members) REQUIRE(world.characters().position[i].y < 1.0);
    }
    for (const std::int32_t i : world.group(1).members) {
        CHECK(distance(world.characters().position[i], Vec2{10, 0}) < 4.0);
        CHECK(length(world.characters().velocity[i]) < 0.1);
    }
}

TEST_CASE("who follows a group that goes each for itself follows its people, not their target") {
    WorldDef def{.box = {{-20, -20}, {60, 20}}};
    GroupDef group{.count = 8};
    def.groups.push_back(group);
    def.groups[0].bodies = {Body{.maxSpeed = 1.0}};
    group.position = {-8, 0};
    def.groups.push_back(group);
    World world = World::create(def).value();
    tell(world, Order::go({40, 0}));
    tell(world, Order::follow(world.group(0).id, {-5, 0}), 1);
    for (int k = 0; k < 8; ++k) {
        run(world, 5.0);
        CHECK(middleOf(world, 0).x - middleOf(world, 1).x == doctest::Approx(5.0).epsilon(0.4));
    }
}
