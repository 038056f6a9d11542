// A building set on people: they leave it by the shortest way, at walking speed.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Sets a building on the middle of a crowd and checks all that SPEC promises of it.
void setOnCrowd(std::int32_t count, double spacing, double halfWidth, double halfHeight) {
    CAPTURE(count);
    CAPTURE(halfWidth);
    WorldDef def{.box = {{-40, -40}, {40, 40}}};
    GroupDef group{.count = count, .formation = {.spacing = spacing}};
    def.groups.push_back(group);
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    REQUIRE(give(world, putThing(block(0.3 - halfWidth, -halfHeight, 0.3 + halfWidth, halfHeight))).ok());
    const double radius = def.parameters.character.radius, top = def.parameters.character.maxSpeed;
    const double depth = std::min(halfWidth, halfHeight) + radius;
    const int steps = static_cast<int>(60.0 * (depth / top + 1.0));
    for (int s = 0; s < steps; ++s) {
        const auto before = copyOf(world.characters().position);
        world.step();
        for (std::size_t i = 0; i < before.size(); ++i)
            CHECK(distance(before[i], world.characters().position[i]) <= 1.05 * top / 60.0);
    }
    const Environment& environment = inspect::environment(world);
    for (int s = 0; s < 300; ++s) {
        for (const Vec2 p : world.characters().position)
            CHECK(environment.distanceToObstacle(p) > radius - 1e-3);
        for (const Vec2 p : world.group(0).placePositions)
            CHECK(environment.distanceToObstacle(p) > radius - 1e-3);
        CHECK(world.contacts().overlapPairs == 0);
        world.step();
    }
}

}  // namespace

TEST_CASE("a building set on a crowd is left at walking speed, by people and places") {
    setOnCrowd(36, 1.0, 1.0, 1.0);
    setOnCrowd(100, 1.0, 2.0, 3.0);
    setOnCrowd(100, 0.8, 1.5, 6.0);
    setOnCrowd(360, 1.0, 4.0, 4.0);
}

TEST_CASE(
    "two buildings that overlap, set on a march of large and small: all get out of the corner between, and "
    "arrive") {
    for (const bool mixed : {false, true}) {
        CAPTURE(mixed);
        WorldDef def{.box = {{-60, -60}, {60, 60}}, .parameters = {.character = {.radius = 0.3}}};
        def.parameters.character.maxSpeed = def.parameters.place.speed = 3.0;
        GroupDef group{.count = 100, .formation = {.spacing = 1.6}};
        for (int i = 0; mixed && i < 100; ++i)
            group.bodies.push_back({.radius = i % 2 ? 0.3 : 0.6, .maxSpeed = i % 2 ? 3.0 : 5.0});
        def.groups.push_back(group);
        World world = World::create(def).value();
        run(world, 1.0);
        tell(world, Order::move({40, 0}));
        run(world, 2.0);
        Vec2 middle;
        for (const Vec2 p : world.characters().position) middle += p / 100.0;
        const auto building = [](Vec2 centre, double angle) {
            ObstacleDef out;
            const Pose pose{centre, {std::cos(angle), std::sin(angle)}};
            for (const Vec2 corner : {Vec2{-6, -6}, Vec2{6, -6}, Vec2{6, 6}, Vec2{-6, 6}})
                out.polygon.push_back(pose.apply(corner));
            return out;
        };
        REQUIRE(give(world, putThing(building(middle, 0.3))).ok());
        REQUIRE(give(world, putThing(building(middle + Vec2{9.6, 0}, -0.5))).ok());
        run(world, 8.0);
        CHECK(world.contacts().overlapPairs == 0);
        run(world, 22.0);
        CHECK(world.group(0).orders.empty());
        for (const std::int32_t i : world.group(0).members) {
            const std::int32_t place = world.characters().place[i];
            REQUIRE(place >= 0);
            CHECK(distance(world.characters().position[i], world.group(0).placeTargets[place]) < 0.5);
        }
    }
}
