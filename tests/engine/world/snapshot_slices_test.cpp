// A saved world goes on from any slice of a plan, with what still waits in its queue.
#include <doctest.h>

#include "engine/assignment/planning/plan.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("a world saved at each slice of a plan goes on bit for bit") {
    WorldDef def = busyFloor(5);
    def.parameters.plan.solver = PlanSolver::Exact;  // Fast plans are made in one step.
    def.parameters.plan.period = 7;
    World world = World::create(def).value();
    REQUIRE(give(world, SetPose{world.group(0).id, {6, -6}, 0.5}).ok());
    for (int s = 0; s < 40; ++s) world.step();
    std::vector<std::vector<std::uint8_t>> saved;
    std::vector<std::uint64_t> hashes;
    int pending = 0;
    for (int s = 0; s < 31; ++s) {
        for (std::size_t g = 0; g < world.groupCount(); ++g) pending += inspect::plan(world, g).pending();
        saved.push_back(world.snapshot());
        hashes.push_back(world.hash());
        world.step();
    }
    CHECK(pending > 20);                                // Most lay within a period.
    for (std::size_t slice = 0; slice < 15; ++slice) {  // Two periods.
        CAPTURE(slice);
        Result<World> copy = World::restore(saved[slice], static_cast<std::int32_t>(slice % 2 + 1));
        REQUIRE_MESSAGE(copy.ok(), copy.status().message());
        CHECK(copy->snapshot() == saved[slice]);
        for (std::size_t s = slice; s < slice + 16; ++s) {
            REQUIRE(copy->hash() == hashes[s]);
            copy->step();
        }
    }
    // And with a restore before every step it ends where the plain run ends.
    Result<World> chain = World::restore(saved[0]);
    for (const std::uint64_t hash : hashes) {
        REQUIRE(chain.ok());
        REQUIRE(chain->hash() == hash);
        chain->step();
        chain = World::restore(chain->snapshot());
    }
}

TEST_CASE("commands still waiting are saved too") {
    World world = World::create(openFloor(9)).value();
    REQUIRE(world.submit({10, 1, 0, SetPose{world.group(0).id, {3, 3}, 0}}).ok());
    REQUIRE(world.submit({12, 1, 1, ChangeGroup{.group = world.group(0).id, .count = 12}}).ok());
    for (int s = 0; s < 5; ++s) world.step();
    Result<World> copy = World::restore(world.snapshot());
    REQUIRE(copy.ok());
    for (int s = 0; s < 20; ++s) {
        world.step();
        copy->step();
    }
    CHECK(copy->characters().size() == 12);
    CHECK(copy->hash() == world.hash());
}
