#include <doctest.h>

#include "engine/formation/places/free_space.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

// FreeSpace::isClear() by exact distances alone.
bool isClear(const Environment& environment, const PlaceDef& def, Vec2 p, double distance) {
    const Box inner = environment.def().box.grown(-def.radius - def.clearance);
    return inner.contains(p) && environment.distanceToObstacle(p, 20.0) >= distance;
}

}  // namespace

TEST_CASE("the free space by bounds from the raster equals that by exact distances") {
    Random random(11);
    const PlaceDef def;
    for (int round = 0; round < 8; ++round) {
        Environment environment = emptyWorld(20.0, 0.25);
        for (int k = 0; k < 8; ++k)
            REQUIRE(environment.addObstacle(randomObstacle(random, 9.0, k % 2 == 0)).ok());
        if (round % 2 == 0) REQUIRE(environment.addObstacle(rectangle({-0.3, -10.0}, {0.3, 10.0})).ok());
        environment.setTime(0.7);
        const std::int32_t region = round % 4 - 1;
        RouteGraph routes;
        routes.update(environment, def.radius);
        NearestReachable nearest;
        const FreeSpace space(def, routes, region, nearest);
        for (int k = 0; k < 2000; ++k) {
            const Vec2 p{random.uniform(-10.5, 10.5), random.uniform(-10.5, 10.5)};
            const double distance = random.uniform(0.0, 4.0);
            CHECK(space.isClear(p, distance) == isClear(environment, def, p, distance));
            if (space.clearanceAt(space.cellOf(p)) >= distance)
                CHECK(environment.distanceToObstacle(p, 20.0) >= distance);
            const std::int32_t label = routes.region(p);
            const bool free = isClear(environment, def, p, space.clearRadius());
            if (!free || label >= 0 || region < 0)
                CHECK(space.contains(p) == (free && (region < 0 || label == region)));
        }
    }
}
