// Crowded paths cost more, so people take others.
#include <doctest.h>

#include <cmath>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

// Fast plans see a crowd along the paths they know, not that another path has become cheaper.
TEST_CASE("two paths, one jammed: with density the exact plan avoids the crowd, without it does not") {
    // A wall with two doors at the same distance; a standing crowd of another group fills the upper one.
    const auto goesLow = [](bool density) {
        WorldDef def = openFloor(1);
        def.parameters.plan.solver = PlanSolver::Exact;
        def.obstacles = {block(-0.5, -12, 0.5, -5), block(-0.5, -2.5, 0.5, 2.5), block(-0.5, 5, 0.5, 12)};
        def.groups[0].starts = {{-6, 0.05}};  // A little nearer to the upper door.
        def.groups[0].position = {6, 0.05};
        def.groups.push_back({.count = 20, .formation = {.spacing = 0.55}, .position = {0, 3.75}});
        def.parameters.density.enabled = density;
        World world = World::create(def).value();
        bool lower = false;
        for (int s = 0; s < 15 * 60; ++s) {
            world.step();
            const Vec2 p = world.characters().position[0];
            if (std::fabs(p.x) < 0.3) lower = p.y < 0;
        }
        CHECK(world.characters().position[0].x > 3.0);
        return lower;
    };
    CHECK(goesLow(true));
    CHECK_FALSE(goesLow(false));
}
