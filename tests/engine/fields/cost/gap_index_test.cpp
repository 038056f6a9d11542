// Gaps too narrow for a character stop fields and lines of sight, wherever they lie between the cells.
#include <doctest.h>

#include <cmath>

#include "base/maths.h"
#include "engine/fields/cost/gap_index.h"
#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/eikonal/eikonal_solver.h"

using namespace muster;
using namespace muster::test;

namespace {

// Two wedges whose tips face each other, at an angle to the grid, in a wall across the world.
Environment neck(double width, double angle, double shift) {
    Environment environment = squareWorld(10.0);
    const Rotation turn{cosine(angle), sine(angle)};
    for (const double side : {1.0, -1.0}) {
        ObstacleDef wedge;
        for (const Vec2 p : {Vec2{0.0, side * 0.5 * width}, Vec2{3.0, side * 3.0}, Vec2{3.0, side * 20.0},
                             Vec2{-3.0, side * 20.0}, Vec2{-3.0, side * 3.0}})
            wedge.polygon.push_back(Vec2{shift, 0.3 * shift} + turn.apply(p));
        if (side < 0.0) std::reverse(wedge.polygon.begin(), wedge.polygon.end());
        REQUIRE(environment.addObstacle(wedge).ok());
    }
    environment.setTime(0.0);
    return environment;
}

}  // namespace

TEST_CASE("no path and no line of sight leads through a neck narrower than a character") {
    int closedByGap = 0;
    for (const double width : {0.40, 0.46, 0.48, 0.495, 0.505, 0.56, 0.8})
        for (const double angle : {0.0, 0.2, 0.7})
            for (double shift = 0.0; shift < 0.5; shift += 0.07) {
                CAPTURE(width);
                CAPTURE(angle);
                CAPTURE(shift);
                const Environment environment = neck(width, angle, shift);
                const StaticGround ground = groundOf(environment);
                const Rotation turn{cosine(angle), sine(angle)};
                const Vec2 middle{shift, 0.3 * shift};
                const Vec2 from = middle + turn.apply({-4.0, 0.0}), to = middle + turn.apply({4.0, 0.0});
                const bool open = width > 0.5;
                CHECK(ground.gaps().empty() == open);
                if (!open) CHECK_FALSE(ground.lineOfSight(from, to));
                if (!open) CHECK_FALSE(ground.collisionFree(from, to));
                if (width > 0.75) CHECK(ground.lineOfSight(from, to));
                if (!open)
                    CHECK_FALSE(ground.lineOfSight(middle + turn.apply({-0.12, 0.0}),
                                                   middle + turn.apply({0.12, 0.0})));
                EikonalSolver solver;
                CostField field;
                for (const GroundLevel& level : {ground.fineLevel(), ground.middle()}) {
                    CAPTURE(level.grid().cell);
                    solver.solve(level.unitCost(), to, {}, field);
                    const bool reached = field.squaredCost(from) < 1e6;
                    if (!open) CHECK_FALSE(reached);
                    if (width > 0.75 && level.grid().cell < 0.3) CHECK(reached);
                }
                // Would it be open by the cells alone?
                UnitCost cells = ground.fineLevel().unitCost();
                std::vector<float> unit(cells.cells.size());
                cells.nodes.clear();
                const GroundRasters rasters{cells.grid, environment.staticClearance(),
                                            environment.travelSpeed()};
                computeGroundCost(rasters, 0.25, 1.0, 0, cells.grid.count(),
                                  {cells.cells, unit, cells.nodes});
                solver.solve(cells, to, {}, field);
                if (!open && field.squaredCost(from) < 1e6) ++closedByGap;
                if (ground.hasCoarse() && !open) {
                    solver.solve(ground.coarse(), to, {}, field);
                    CHECK_FALSE(field.squaredCost(from) < 1e6);
                }
            }
    MESSAGE("necks that cells alone leave open: " << closedByGap);
    CHECK(closedByGap > 0);
}
