// Costs read from local fields, against the visibility graph.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/eikonal/geodesic_oracle.h"
#include "engine/fields/geodesics/local_costs.h"

using namespace muster;
using namespace muster::test;

namespace {

/// A block of 6 by 8 metres.
struct LocalScene {
    Environment environment = squareWorld(16.0);
    StaticGround ground;
    DynamicCost dynamicCost;
    ThreadPool pool{1};
    std::vector<Vec2> places;

    LocalScene() {
        REQUIRE(environment.addObstacle(rectangle(-3, -4, 3, 4)).ok());
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
        DensityField density(environment.def().box, {});
        dynamicCost.update({}, environment, density, 0.25);
    }
    GroundLevel level(bool wide) const { return wide ? ground.middle() : ground.fineLevel(); }
};

const std::vector<Shape> kBlock = {{{{-3, -4}, {3, -4}, {3, 4}, {-3, 4}}}};

}  // namespace

TEST_CASE("costs around a block, by local fields of either size, are nearly exact") {
    for (const bool wide : {false, true}) {
        CAPTURE(wide);
        LocalScene scene;
        Random random(3);
        const double reach = wide ? 6.0 : 2.5;
        for (int j = 0; j < 60; ++j) scene.places.push_back(freeSpot(scene.environment, random, 6.0));
        LocalCosts costs({512, wide ? 18 : 16});
        costs.beginStep(scene.ground, scene.level(wide), scene.dynamicCost, scene.places);
        for (int j = 0; j < 60; ++j) costs.request(j, false);
        costs.updateLandmarks(false);
        costs.solveRequested(512, scene.pool);
        costs.updateLandmarks(true);
        std::vector<double> errors;
        for (int j = 0; j < 60; ++j) {
            REQUIRE(costs.known(j));
            const GeodesicOracle oracle(kBlock, 0.25, scene.places[j]);
            for (int k = 0; k < 40; ++k) {
                const Vec2 p = scene.places[j] +
                               Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
                if (!(scene.environment.distanceToObstacle(p) >= 0.27) ||
                    scene.ground.lineOfSight(p, scene.places[j]))
                    continue;
                REQUIRE(costs.covers(p, j));
                const double line = distance(p, scene.places[j]);
                const double known = costs.cost(p, j, line);
                if (!std::isfinite(known)) continue;  // The path leaves the local field.
                REQUIRE(known >= line);
                errors.push_back(std::fabs(known - oracle.cost(p)) / oracle.cost(p));
            }
        }
        REQUIRE(errors.size() > 20);
        std::sort(errors.begin(), errors.end());
        MESSAGE("hidden: " << errors.size() << ", median " << errors[errors.size() / 2] << ", worst "
                           << errors.back());
        CHECK(errors[errors.size() / 2] < (wide ? 0.02 : 0.01));
        CHECK(errors.back() < 0.06);
    }
}

TEST_CASE("places without a request are unknown, and requests for assignees are served first") {
    LocalScene scene;
    scene.places = {{-5.0, 0.0}, {5.0, 0.0}};
    LocalCosts costs({64, 16});
    costs.beginStep(scene.ground, scene.level(false), scene.dynamicCost, scene.places);
    CHECK(std::isinf(costs.cost({-5.0, 2.0}, 0, 2.0)));
    costs.request(0, false);
    costs.request(1, true);
    costs.updateLandmarks(false);
    costs.solveRequested(1, scene.pool);
    costs.updateLandmarks(true);
    CHECK_FALSE(costs.known(0));
    CHECK(costs.known(1));
    costs.solveRequested(1, scene.pool);
    costs.updateLandmarks(true);
    CHECK(costs.known(0));
    // A request that is not repeated expires.
    for (int k = 0; k < 70; ++k) costs.updateLandmarks(true);
    CHECK_FALSE(costs.requested(0));
    CHECK_FALSE(costs.known(0));
}
