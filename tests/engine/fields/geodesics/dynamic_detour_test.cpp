// Detours around moving obstacles, against cost fields of a fine ground.
#include "engine/fields/geodesics/one_vertex_paths.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

namespace {

// A disc that drives north.
ObstacleDef cart() {
    return {
        .centre = {0, -3}, .radius = 0.8, .path = {.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {0, 15}, 0.0}}}};
}

Environment withCart(double cell) {
    Environment environment = Environment::create({.box = {{-16, -16}, {16, 16}}, .cell = cell}).value();
    REQUIRE(environment.addObstacle(cart()).ok());
    environment.setTime(2.0);
    return environment;
}

struct DetourScene {
    explicit DetourScene(const Environment& environment) {
        ground = groundOf(environment);
        const DensityField density({{-16, -16}, {16, 16}}, {});
        dynamicCost.update({}, environment, density, 0.25);
    }
    double between(Vec2 a, Vec2 b) const { return dynamicCostBetween(ground, dynamicCost, a, b); }
    StaticGround ground;
    DynamicCost dynamicCost;
};

}  // namespace

TEST_CASE("a detour is near the cheapest path around a cart, and never costlier than the straight line") {
    const Environment environment = withCart(0.25);
    const Environment fine = withCart(0.125);
    const DetourScene scene(environment);
    UnitCostBuilder builder;
    UnitCost cost;
    builder.build({}, fine, DensityField({{-16, -16}, {16, 16}}, {}), 0.25, cost);
    EikonalSolver solver;
    CostField field;
    Random random(8);
    double error = 0.0;
    double straightError = 0.0;
    double total = 0.0;
    for (int k = 0; k < 60; ++k) {
        const Vec2 to = freeSpot(environment, random, 5.0);
        solver.solve(cost, to, {}, field);
        for (int m = 0; m < 20; ++m) {
            const Vec2 from = freeSpot(environment, random, 5.0);
            const double exact = field.cost(from) - distance(from, to);
            const double detour = scene.between(from, to);
            REQUIRE(detour <= scene.dynamicCost.relativeAlong(from, to));
            REQUIRE(detour > exact - 0.25 - 0.1 * exact);
            error += std::fabs(detour - exact);
            straightError += std::fabs(scene.dynamicCost.relativeAlong(from, to) - exact);
            total += exact;
        }
    }
    CAPTURE(error / total);
    CAPTURE(straightError / total);
    CHECK(total > 100.0);
    // Straight through the cart the cost is eleven times that around it.
    CHECK(error < total);
    CHECK(error < 0.12 * straightError);
}

TEST_CASE("a point beside a cart has no blocked cost") {
    const DetourScene scene(withCart(0.25));
    // The cart's centre is at y = 0 now; a character beside it touches it at 1.05 m.
    const Vec2 touching{-1.06, -0.1};
    CHECK(scene.dynamicCost.movingCostAt(touching) < 8.5);
    CHECK(scene.dynamicCost.movingCostAt({0.1, 0.1}) == DynamicCost::kBlocked);
    CHECK(scene.dynamicCost.relativeAlong(touching, touching - Vec2{0.2, 0.0}) < 0.2 * 8.5);
}

TEST_CASE("no detour leads through a wall") {
    Environment environment = withCart(0.25);
    // On both sides of the cart's path, a metre from the straight line.
    REQUIRE(environment.addObstacle(rectangle(-0.4, 2.0, 0.4, 2.4)).ok());
    REQUIRE(environment.addObstacle(rectangle(-4.0, -12.0, 4.0, -3.0)).ok());
    environment.setTime(2.0);
    const DetourScene scene(environment);
    const DetourScene withoutWalls(withCart(0.25));
    Random random(3);
    int longer = 0;
    for (int k = 0; k < 300; ++k) {
        const Vec2 from = freeSpot(environment, random, 5.0);
        const Vec2 to = freeSpot(environment, random, 5.0);
        REQUIRE(scene.between(from, to) <= scene.dynamicCost.relativeAlong(from, to));
        REQUIRE(scene.between(from, to) >= withoutWalls.between(from, to) - 1e-9);
        longer += scene.between(from, to) > withoutWalls.between(from, to) + 1e-9 ? 1 : 0;
    }
    CHECK(longer > 0);  // Walls block a detour that exists without them.
}
