// Who makes the plans can change while a world runs.
#include <doctest.h>

#include <algorithm>
#include <string>

#include "engine/assignment/planning/plan.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

void solveBy(World& world, PlanSolver solver) {
    REQUIRE(give(world, SetParameter{"plan.solver", static_cast<double>(solver)}).ok());
}

void stepBy(World& world, int steps) {
    for (int i = 0; i < steps; ++i) {
        world.step();
        REQUIRE(world.rejections().empty());
    }
}

}  // namespace

TEST_CASE("changing plan.solver exchanges the plan of every group in that step, and nobody loses a place") {
    WorldDef def = busyFloor(5);
    def.parameters.plan.solver = PlanSolver::Exact;
    World world = World::create(def).value();
    stepBy(world, 20);
    for (const PlanSolver solver : {PlanSolver::Fast, PlanSolver::Exact, PlanSolver::Fast}) {
        solveBy(world, solver);
        stepBy(world, 1);
        std::vector<std::vector<std::int32_t>> taken(world.groupCount());
        for (std::size_t i = 0; i < world.characters().size(); ++i) {
            REQUIRE(world.characters().place[i] >= 0);
            taken[world.characters().group[i]].push_back(world.characters().place[i]);
        }
        for (std::size_t g = 0; g < world.groupCount(); ++g) {
            CHECK(std::string(inspect::plan(world, g).name()) ==
                  (solver == PlanSolver::Fast ? "fast" : "exact"));
            CHECK(world.group(g).walk.longest > 0.0);
            std::sort(taken[g].begin(), taken[g].end());
            CHECK(std::adjacent_find(taken[g].begin(), taken[g].end()) == taken[g].end());
        }
        stepBy(world, 30);
    }
}

TEST_CASE("setting the solver that is at work changes nothing") {
    for (const PlanSolver solver : {PlanSolver::Exact, PlanSolver::Fast}) {
        WorldDef def = busyFloor(6);
        def.parameters.plan.solver = solver;
        World touched = World::create(def).value(), left = World::create(def).value();
        for (int i = 0; i < 24; ++i) {
            if (i % 5 == 3) solveBy(touched, solver);
            stepBy(touched, 1);
            stepBy(left, 1);
            CHECK(copyOf(touched.characters().position) == copyOf(left.characters().position));
        }
    }
}

TEST_CASE("a world whose solver was exchanged goes on from its snapshot bit for bit") {
    WorldDef def = busyFloor(7);
    def.parameters.plan.solver = PlanSolver::Exact;
    World world = World::create(def).value();
    stepBy(world, 10);
    solveBy(world, PlanSolver::Fast);
    for (int round = 0; round < 3; ++round) {
        stepBy(world, 7);
        CHECK(std::string(inspect::plan(World::restore(world.snapshot()).value(), 0).name()) == "fast");
        checkGoesOn(world, 7);
    }
}
