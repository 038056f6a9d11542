// Those who stand hand their places on to who cannot pass them (SPEC A7).
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A niche that is one wide, with a place in it. Two stand before it, 0.4 m apart between walls. By the sum
/// of ways the third character would go into the niche, between the two.
WorldDef niche(PlanSolver solver) {
    WorldDef def{.box = {{-4, -4}, {4, 4}}};
    constexpr double kMiddle = 0.125;  // Of a column of cells.
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        def.obstacles.push_back(block(kMiddle + x0, y0, kMiddle + x1, y1));
    };
    wall(-3, -0.6, -0.72, 2);
    wall(0.72, -0.6, 3, 2);
    wall(-0.72, 0.28, -0.28, 2);
    wall(0.28, 0.28, 0.72, 2);
    wall(-0.28, 0.95, 0.28, 2);
    def.groups.push_back(
        {.count = 3,
         .formation = {.kind = FormationKind::Points,
                       .points = {{kMiddle - 0.45, 0}, {kMiddle + 0.45, 0}, {kMiddle, 0.625}}},
         .starts = {{kMiddle - 0.45, 0}, {kMiddle + 0.45, 0}, {kMiddle, -0.6}}});
    def.parameters.plan.solver = solver;
    def.parameters.plan.exponent = 1.0;
    def.parameters.field.enabled = false;
    return def;
}

}  // namespace

TEST_CASE("who cannot pass two that stand comes to a place all the same") {
    for (const PlanSolver solver : {PlanSolver::Fast, PlanSolver::Exact}) {
        World world = World::create(niche(solver)).value();
        RunMetrics metrics(world);
        for (int s = 0; s < 600; ++s) {
            world.step();
            metrics.observe(world);
        }
        const RunFigures figures = metrics.figures(world, false);
        CHECK(figures.arrived100 > 0.0);
        CHECK(figures.arrived100 < 6.0);
    }
}
