// Ways bent round moving things, beside the fields of a fine ground.
#include "geodesics/crowd_detour.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "cost/ground_scene.h"
#include "cost/unit_cost_builder.h"
#include "eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

namespace {

// A disc that drives north.
ObstacleDef cart() {
    ObstacleDef def;
    def.radius = 0.8;
    def.centre = {0, -3};
    def.path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {0, 15}, 0.0}};
    return def;
}

Environment carted(double cell) {
    EnvironmentDef def;
    def.box = {{-16, -16}, {16, 16}};
    def.cell = cell;
    Environment environment = Environment::create(def).value();
    REQUIRE(environment.addObstacle(cart()).ok());
    environment.setTime(2.0);
    return environment;
}

struct Scene {
    explicit Scene(const Environment& environment) {
        ground = groundOf(environment);
        const DensityField density({{-16, -16}, {16, 16}}, {});
        excess.update({}, environment, density, 0.25);
    }
    double between(Vec2 a, Vec2 b) const { return excessBetween(ground, excess, a, b); }
    StaticGround ground;
    DynamicCost excess;
};

}  // namespace

TEST_CASE("a way bent once is near the cheapest round a cart, and never dearer than the straight one") {
    const Environment environment = carted(0.25);
    const Environment fine = carted(0.125);
    const Scene scene(environment);
    UnitCostBuilder builder;
    UnitCost cost;
    builder.build({}, fine, DensityField({{-16, -16}, {16, 16}}, {}), 0.25, cost);
    EikonalSolver solver;
    CostField field;
    Random random(8);
    double off = 0.0;
    double straightOff = 0.0;
    double whole = 0.0;
    for (int k = 0; k < 60; ++k) {
        const Vec2 to = freeSpot(environment, random, 5.0);
        solver.solve(cost, to, {}, field);
        for (int m = 0; m < 20; ++m) {
            const Vec2 from = freeSpot(environment, random, 5.0);
            const double exact = field.cost(from) - distance(from, to);
            const double bent = scene.between(from, to);
            REQUIRE(bent <= scene.excess.relativeAlong(from, to));
            REQUIRE(bent > exact - 0.25 - 0.1 * exact);
            off += std::fabs(bent - exact);
            straightOff += std::fabs(scene.excess.relativeAlong(from, to) - exact);
            whole += exact;
        }
    }
    CAPTURE(off / whole);
    CAPTURE(straightOff / whole);
    CHECK(whole > 100.0);
    // Straight through the cart it is eleven times as dear as round it.
    CHECK(off < whole);
    CHECK(off < 0.12 * straightOff);
}

TEST_CASE("who stands beside a cart is not inside it") {
    const Scene scene(carted(0.25));
    // The cart's middle is at y = 0 now; its side leaves room at 1.05 m.
    const Vec2 beside{-1.06, -0.1};
    CHECK(scene.excess.movingCostAt(beside) < 8.5);
    CHECK(scene.excess.movingCostAt({0.1, 0.1}) == DynamicCost::kBlocked);
    CHECK(scene.excess.relativeAlong(beside, beside - Vec2{0.2, 0.0}) < 0.2 * 8.5);
}

TEST_CASE("no way is bent through a wall") {
    Environment environment = carted(0.25);
    // On both sides of the cart's way, a step from the line asked for.
    REQUIRE(environment.addObstacle(rectangle(-0.4, 2.0, 0.4, 2.4)).ok());
    REQUIRE(environment.addObstacle(rectangle(-4.0, -12.0, 4.0, -3.0)).ok());
    environment.setTime(2.0);
    const Scene scene(environment);
    const Scene open(carted(0.25));
    Random random(3);
    int kept = 0;
    for (int k = 0; k < 300; ++k) {
        const Vec2 from = freeSpot(environment, random, 5.0);
        const Vec2 to = freeSpot(environment, random, 5.0);
        REQUIRE(scene.between(from, to) <= scene.excess.relativeAlong(from, to));
        REQUIRE(scene.between(from, to) >= open.between(from, to) - 1e-9);
        kept += scene.between(from, to) > open.between(from, to) + 1e-9 ? 1 : 0;
    }
    CHECK(kept > 0);  // By walls, on a way that is bent where there are none.
}
