// Queries beside a wall so thin that cells on both of its sides lie around a point.
#include <doctest.h>

#include "engine/fields/cost/cost_scene.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("beside a thin wall the cost is that of the way round it") {
    UnitCost cost = makeCost({{0, 0}, {20, 20}}, 1.0, [](Vec2) { return isotropic(1.0); });
    // Between the columns 9 and 10, in all rows but the uppermost two.
    for (std::int32_t y = 0; y < 18; ++y) {
        cost.cells[cost.grid.index({9, y})].east = kUnreachableCost;
        cost.cells[cost.grid.index({10, y})].west = kUnreachableCost;
    }
    EikonalSolver solver;
    CostField field;
    const FieldSeed seed{{15, 2}};
    solver.solve(cost, std::span(&seed, 1), field);
    for (double y = 3.2; y < 16.0; y += 0.7)
        for (const double x : {9.5, 9.6, 9.9}) {
            CAPTURE(x);
            CAPTURE(y);
            // At least that of a cell farther off the wall, but for the way to it.
            CHECK(field.cost({x, y}) > field.value({8, static_cast<std::int32_t>(y)}) - 2.5);
            CHECK(field.direction({x, y}).x < 0.5);
            CHECK(field.direction({x, y}).y > 0.5);
            CHECK(field.cost({19.99 - x, y}) < 20.0);
        }
}
