// Plans that are worked on while the crowd walks and while the program has the world: nothing it does then
// may disturb them, and nobody can tell on how many threads they were made.
#include <doctest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/assignment/planning/plan.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef bigFloor(std::uint64_t seed) {
    WorldDef def = busyFloor(seed);
    def.groups[0].count = 240;
    def.groups[0].formation.spacing = 0.6;
    def.groups[1].count = 60;
    return def;
}

int pendingPlans(const World& world) {
    int pending = 0;
    for (std::size_t g = 0; g < world.groupCount(); ++g) pending += inspect::plan(world, g).pending();
    return pending;
}

// What a program may do between two steps, while plans are pending.
void disturb(World& world, int step) {
    const std::vector<CommandBody> bodies = {
        ChangeGroup{.group = world.group(0).id, .count = 150 + step},
        ChangeGroup{.group = world.group(0).id, .formation = FormationDef{}},
        putThing(tree({-4.0 + 0.1 * step, 4}, 0.5)),
        SetParameter{"plan.solver", static_cast<double>(PlanSolver::Exact)},
        SetParameter{"plan.solver", static_cast<double>(PlanSolver::Fast)},
        SetPose{world.group(0).id, {4, 0.1 * step}, 0.3},
        RemoveGroup{world.group(world.groupCount() - 1).id},
    };
    const auto next = static_cast<std::size_t>(step / 5);
    if (step % 5 == 0 && next < bodies.size()) REQUIRE(give(world, bodies[next]).ok());
}

std::vector<std::uint64_t> disturbedRun(std::int32_t threads, bool looks) {
    World world = World::create(bigFloor(21), threads).value();
    std::vector<std::uint64_t> hashes;
    for (int step = 0; step < 45; ++step) {
        world.step();
        disturb(world, step);
        if (looks || step == 44) hashes.push_back(world.hash());
    }
    return hashes;
}

}  // namespace

TEST_CASE("a plan is pending after a step, and its places are taken in the next") {
    World world = World::create(bigFloor(20), 2).value();
    world.step();  // The first is made at once.
    CHECK(pendingPlans(world) == 0);
    for (const std::int32_t place : world.characters().place) CHECK(place >= 0);
    for (int step = 0; step < 10; ++step) {
        world.step();
        CHECK(pendingPlans(world) == 2);
    }
}

TEST_CASE(
    "whatever a program does while plans are pending, any number of threads goes through the same states") {
    const std::vector<std::uint64_t> expected = disturbedRun(1, true);
    for (const std::int32_t threads : {2, 3, 8}) CHECK(disturbedRun(threads, true) == expected);
    // To look at the state is no disturbance either.
    for (const std::int32_t threads : {1, 2}) CHECK(disturbedRun(threads, false).back() == expected.back());
}

TEST_CASE("a world saved while plans are pending goes on bit for bit") {
    World world = World::create(bigFloor(22), 2).value();
    for (int step = 0; step < 20; ++step) world.step();
    REQUIRE(pendingPlans(world) == 2);
    checkGoesOn(world, 20);
}

TEST_CASE("a world may be dropped or moved while plans are pending") {
    for (int k = 0; k < 20; ++k) {
        auto world = std::make_unique<World>(World::create(bigFloor(23), 2).value());
        for (int step = 0; step < 3 + k % 2; ++step) world->step();
        if (k % 3 == 0) {
            World moved = std::move(*world);
            world.reset();
            moved.step();
            CHECK(moved.stepCount() == static_cast<std::uint32_t>(4 + k % 2));
        }
    }
}

TEST_CASE("the work of plans goes to a foreign runner that takes it") {
    struct Runner {
        std::thread thread;
        int launches = 0;
    } own;
    TaskRunner runner{
        1, &own, [](void*, std::int32_t count, void (*task)(void*, std::int32_t, std::int32_t), void* of) {
            for (std::int32_t i = 0; i < count; ++i) task(of, i, 0);
        }};
    runner.launch = [](void* context, void (*task)(void*), void* of) {
        auto& self = *static_cast<Runner*>(context);
        ++self.launches;
        self.thread = std::thread(task, of);
    };
    runner.wait = [](void* context) { static_cast<Runner*>(context)->thread.join(); };
    World foreign = World::create(bigFloor(24), runner).value();
    World world = World::create(bigFloor(24)).value();
    for (int step = 0; step < 30; ++step) {
        foreign.step();
        world.step();
        REQUIRE(foreign.hash() == world.hash());
    }
    CHECK(own.launches == 29);
}
