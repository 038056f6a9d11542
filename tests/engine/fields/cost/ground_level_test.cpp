// The static ground on cells twice as wide, and thin walls.
#include <doctest.h>

#include <cmath>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("wider cells have the clearance and the unit cost of the ground that they cover") {
    Environment environment = squareWorld(12.0);
    REQUIRE(environment.addObstacle(rectangle(-4, -3, 2, 5)).ok());
    REQUIRE(environment.addPatch(slowBox(5, -6, 9, 6, 0.25)).ok());
    environment.setTime(0.0);
    StaticGround ground;
    ground.update(environment, 1.0, 0.25);
    const GroundLevel level = ground.middle();
    const Grid& grid = level.grid();
    const UnitCost cost = level.unitCost();
    CHECK(grid.cell == 2.0 * ground.grid().cell);
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Vec2 p = grid.centre(grid.at(k));
        const double clearance = environment.distanceToObstacle(p) - 0.25;
        // Clearance is known up to a limit, and kinks where two walls are as near.
        if (clearance < 1.0) REQUIRE(std::fabs(level.clearance(k) - clearance) < 0.1);
        REQUIRE(level.blocked(k) == (level.clearance(k) < 0.0f));
    }
    const auto east = [&](Vec2 p) { return cost.cells[grid.index(grid.cellOf(p))].east; };
    CHECK(east({-8.1, 0.1}) == doctest::Approx(1.0));
    CHECK(east({7.1, 0.1}) == doctest::Approx(4.0));
    CHECK(level.freeCellNear({-1.1, 1.1}) == -1);
    CHECK(level.freeCellNear({-4.1, 1.1}) >= 0);
}

TEST_CASE("no path leads through a wall thinner than a cell") {
    // From walls without any thickness to such as are thicker than a cell, wherever they stand in it.
    for (const double thickness : {0.02, 0.1, 0.3, 0.7})
        for (double shift = 0.0; shift < 0.5; shift += 0.06) {
            CAPTURE(thickness);
            CAPTURE(shift);
            Environment environment = squareWorld(8.0);
            REQUIRE(environment.addObstacle(rectangle(shift, -8, shift + thickness, 4)).ok());
            environment.setTime(0.0);
            StaticGround ground;
            ground.update(environment, 1.0, 0.25);
            for (const UnitCost& cost : {ground.fineLevel().unitCost(), ground.middle().unitCost()}) {
                EikonalSolver solver;
                CostField field;
                const Vec2 from{-2.0, 0.0}, to{3.0, 0.0};
                solver.solve(cost, to, {}, field);
                // Round the end of the wall, less what cells of half a metre may be off.
                const double least = std::hypot(shift + 2.0, 4.0) + std::hypot(3.0 - shift - thickness, 4.0);
                CHECK(field.cost(from) > 0.99 * least);
                CHECK(field.cost(from) < least + thickness + 1.2);
            }
        }
}
