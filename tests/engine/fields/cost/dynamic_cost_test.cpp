// Line integrals of the dynamic cost, against the unit cost of the cells.
#include <doctest.h>

#include <cmath>

#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

namespace {

// 20 x 20 characters at a distance of `apart` metres, all with the same velocity.
void block(double apart, Vec2 velocity, DensityField& density) {
    std::vector<Vec2> positions;
    for (int k = 0; k < 400; ++k) positions.push_back(Vec2{(k % 20 - 9.5) * apart, (k / 20 - 9.5) * apart});
    density.splat(positions, std::vector<Vec2>(positions.size(), velocity));
}

// The integral from the unit costs of ground cells, sampled densely.
double alongCells(const UnitCost& cost, Vec2 a, Vec2 b) {
    const Vec2 to = (b - a) / distance(a, b);
    double sum = 0.0;
    for (int k = 0; k < 400; ++k) {
        const CellCost&
            c = cost.cells[cost.grid.index(cost.grid.nearestCell(a + (b - a) * ((k + 0.5) / 400)))];
        const double x = to.x * (to.x > 0.0 ? c.east : c.west);
        const double y = to.y * (to.y > 0.0 ? c.north : c.south);
        sum += std::sqrt(x * x + y * y) - 1.0;
    }
    return sum / 400 * distance(a, b);
}

}  // namespace

TEST_CASE("without a crowd and moving things the dynamic cost is zero") {
    const Environment environment = squareWorld(16.0);
    DensityField density({{-16, -16}, {16, 16}}, {});
    DynamicCost dynamic;
    dynamic.update({}, environment, density, 0.25);
    CHECK(dynamic.empty());
    CHECK(dynamic.relativeAlong({-9, 0}, {9, 3}) == 0.0);
    block(1.2, {0, 0}, density);  // 0.7 per square metre slows nobody.
    dynamic.update({}, environment, density, 0.25);
    CHECK(dynamic.relativeAlong({-9, 0}, {9, 3}) == 0.0);
}

TEST_CASE("a dense crowd costs along a line what the unit cost of the cells says") {
    const Environment environment = squareWorld(16.0);
    DensityField density({{-16, -16}, {16, 16}}, {});
    const Parameters parameters;
    for (const Vec2 velocity : {Vec2{0, 0}, Vec2{1.2, 0}, Vec2{-0.6, 0.8}}) {
        block(0.6, velocity, density);  // 2.8 per square metre.
        DynamicCost dynamic;
        dynamic.update(parameters, environment, density, 0.25);
        UnitCostBuilder builder;
        UnitCost cost;
        builder.build(parameters, environment, density, 0.25, cost);
        Random random(4);
        double off = 0.0;
        double whole = 0.0;
        for (int k = 0; k < 200; ++k) {
            const Vec2 a{random.uniform(-9, 9), random.uniform(-9, 9)};
            const Vec2 b = a + Vec2{random.uniform(-3, 3), random.uniform(-3, 3)};
            off += std::fabs(dynamic.relativeAlong(a, b) - alongCells(cost, a, b));
            whole += alongCells(cost, a, b);
        }
        CHECK(whole > 100.0);
        CAPTURE(off / whole);
        // Densities are read on their own cells, which are four times as wide as those of the ground.
        CHECK(off < 0.16 * whole);
    }
    // With the stream it costs less than against it.
    block(0.6, {1.2, 0}, density);
    DynamicCost dynamic;
    dynamic.update(parameters, environment, density, 0.25);
    CHECK(dynamic.relativeAlong({-3, 0}, {3, 0}) < 0.3 * dynamic.relativeAlong({3, 0}, {-3, 0}));
}

TEST_CASE("at the edge of slow ground the flow counts relative to the speed of each ground") {
    Environment environment = squareWorld(16.0);
    REQUIRE(environment.addPatch(slowBox(0.13, -16, 16, 16, 0.2)).ok());
    const StaticGround ground = groundOf(environment);
    DensityField density({{-16, -16}, {16, 16}}, {});
    // The crowd on the patch moves at the full speed there, which would be a jam on open ground.
    block(0.7, {0.24, 0}, density);
    const Parameters parameters;
    DynamicCost dynamic;
    dynamic.update(parameters, environment, density, 0.25);
    UnitCostBuilder builder;
    UnitCost cost;
    UnitCost empty;
    builder.build(parameters, environment, density, 0.25, cost);
    builder.build(parameters, environment, DensityField({{-16, -16}, {16, 16}}, {}), 0.25, empty);
    Random random(9);
    double off = 0.0;
    double byOneGround = 0.0;
    double whole = 0.0;
    for (int k = 0; k < 300; ++k) {
        const Vec2 a{random.uniform(-1.5, 1.5), random.uniform(-5, 5)};
        const Vec2 b = a + Vec2{random.uniform(-1, 1), random.uniform(-1, 1)};
        const double exact = alongCells(cost, a, b) - alongCells(empty, a, b);
        off += std::fabs(dynamic.costAlong(ground, a, b) - exact);
        byOneGround += std::fabs(ground.unitCost(a) * dynamic.relativeAlong(a, b) - exact);
        whole += exact;
    }
    CAPTURE(off / whole);
    CAPTURE(byOneGround / whole);
    CHECK(whole > 30.0);
    CHECK(off < 0.17 * whole);
    CHECK(off < 0.85 * byOneGround);
    // On uniform ground it is the relative integral times the unit cost.
    const StaticGround uniform = groundOf(squareWorld(16.0));
    CHECK(dynamic.costAlong(uniform, {-5, 0}, {-2, 1}) == dynamic.relativeAlong({-5, 0}, {-2, 1}));
}

TEST_CASE("ground ahead of a moving obstacle is expensive, under it blocked, and free again behind it") {
    Environment environment = squareWorld(16.0);
    ObstacleDef cart = rectangle(-1, -0.5, 1, 0.5);
    cart.path.waypoints = {{0.0, {0, 0}, 0.0}, {5.0, {10, 0}, 0.0}};
    REQUIRE(environment.addObstacle(cart).ok());
    environment.setTime(0.5);
    DensityField density({{-16, -16}, {16, 16}}, {});
    const Parameters parameters;
    DynamicCost dynamic;
    dynamic.update(parameters, environment, density, 0.25);
    UnitCostBuilder builder;
    UnitCost cost;
    builder.build(parameters, environment, density, 0.25, cost);
    const Vec2 a{4.0, -3.0};
    const Vec2 b{4.0, 3.0};
    CHECK(dynamic.relativeAlong(a, b) == doctest::Approx(alongCells(cost, a, b)).epsilon(0.1));
    CHECK(dynamic.relativeAlong({1, -2}, {1, 2}) > 15.0);
    CHECK(dynamic.relativeAlong({-6, -2}, {-6, 2}) == 0.0);
    environment.setTime(4.5);
    dynamic.update(parameters, environment, density, 0.25);
    CHECK(dynamic.relativeAlong({1, -2}, {1, 2}) == 0.0);
}

TEST_CASE("of a line that passes something moving no sample is left out") {
    Environment environment = squareWorld(16.0);
    ObstacleDef cart = rectangle(-1, -0.5, 1, 0.5);
    cart.path.waypoints = {{0.0, {0, 0}, 0.0}, {5.0, {10, 0}, 0.0}};
    REQUIRE(environment.addObstacle(cart).ok());
    environment.setTime(0.5);
    const DensityField density({{-16, -16}, {16, 16}}, {});
    DynamicCost dynamic;
    dynamic.update({}, environment, density, 0.25);
    Random random(3);
    int costly = 0;
    for (int round = 0; round < 3000; ++round) {
        const Vec2 a{random.uniform(-15, 15), random.uniform(-15, 15)};
        Vec2 b{random.uniform(-15, 15), random.uniform(-15, 15)};
        if (round % 5 == 0) b.x = a.x;
        if (round % 7 == 0) b.y = a.y + 1e-9;
        const double whole = distance(a, b);
        if (!(whole > 0.0)) continue;
        const int samples = std::min(16, static_cast<int>(whole / 0.5) + 1);
        const double share = 1.0 / samples;
        double sum = 0.0;
        for (int k = 0; k < samples; ++k) sum += dynamic.movingCostAt(a + (b - a) * ((k + 0.5) * share));
        CHECK(dynamic.relativeAlong(a, b) == sum * share * whole);
        costly += sum > 0.0 ? 1 : 0;
    }
    CHECK(costly > 300);
}

TEST_CASE("no part of a crowd is missed, wherever it stands near a line") {
    const Environment environment = squareWorld(16.0);
    Random random(12);
    double off = 0.0, sum = 0.0;
    for (int round = 0; round < 20; ++round) {
        // A small dense group.
        std::vector<Vec2> people;
        const Vec2 middle{random.uniform(-14, 14), random.uniform(-14, 14)};
        for (int k = 0; k < 12; ++k)
            people.push_back(middle + Vec2{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8)});
        DensityField density({{-16, -16}, {16, 16}}, {});
        density.splat(people, std::vector<Vec2>(people.size()));
        DynamicCost dynamic;
        dynamic.update({}, environment, density, 0.25);
        for (int k = 0; k < 200; ++k) {
            const Vec2 a{random.uniform(-15, 15), random.uniform(-15, 15)};
            const Vec2 b{random.uniform(-15, 15), random.uniform(-15, 15)};
            // Short pieces are sampled where they are, so that they miss nothing.
            double pieces = 0.0;
            for (int m = 0; m < 400; ++m)
                pieces += dynamic.relativeAlong(lerp(a, b, m / 400.0), lerp(a, b, (m + 1) / 400.0));
            const double whole = dynamic.relativeAlong(a, b);
            off += std::fabs(whole - pieces);
            sum += pieces;
            if (distance(a, b) < 8.0 && pieces > 2.0) REQUIRE(whole > 0.0);
            if (whole > 0.0) REQUIRE(pieces > 0.0);
        }
    }
    CAPTURE(off / sum);
    CHECK(sum > 100.0);
    CHECK(off < 0.25 * sum);  // Long lines have few samples.
}
