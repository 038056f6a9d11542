// A building set on people: they leave it by the shortest way, at walking speed.
#include <doctest.h>

#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Sets a building on the middle of a crowd and checks all that SPEC promises of it.
void setOnCrowd(std::int32_t count, double spacing, double halfWidth, double halfHeight) {
    CAPTURE(count);
    CAPTURE(halfWidth);
    WorldDef def;
    def.box = {{-40, -40}, {40, 40}};
    GroupDef group;
    group.count = count;
    group.formation.spacing = spacing;
    def.groups.push_back(group);
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    std::uint32_t sequence = 0;
    REQUIRE(
        give(world, sequence, AddObstacle{block(0.3 - halfWidth, -halfHeight, 0.3 + halfWidth, halfHeight)})
            .ok());
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
