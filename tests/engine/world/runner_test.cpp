// Worlds on the task runner of somebody else: any order of items, any workers, the same bits.
#include <doctest.h>

#include <limits>
#include <thread>
#include <vector>

#include "engine/world/world_scenes.h"

using namespace muster;

namespace {

using Task = void (*)(void* context, std::int32_t item, std::int32_t worker);

// Counts the calls of a runner.
struct RunnerLog {
    std::int32_t runs = 0;
    std::int64_t items = 0;
};

void backwards(void* context, std::int32_t count, Task task, void* taskContext) {
    auto& log = *static_cast<RunnerLog*>(context);
    ++log.runs;
    log.items += count;
    for (std::int32_t i = count; i-- > 0;) task(taskContext, i, i % 2);
}

// A thread for each of three workers, each with every third item.
void threadsOfItsOwn(void* context, std::int32_t count, Task task, void* taskContext) {
    ++static_cast<RunnerLog*>(context)->runs;
    std::vector<std::thread> threads;
    for (std::int32_t worker = 0; worker < 3; ++worker)
        threads.emplace_back([=] {
            for (std::int32_t i = worker; i < count; i += 3) task(taskContext, i, worker);
        });
    for (std::thread& thread : threads) thread.join();
}

// Fast plans hand out work in pieces of a hundred characters and more, so they get more of them.
WorldDef floorBy(PlanSolver solver, std::uint64_t seed) {
    WorldDef def = testing::busyFloor(seed);
    def.parameters.plan.solver = solver;
    if (solver == PlanSolver::Fast) def.groups[0].count = 300, def.groups[0].formation.spacing = 0.6;
    return def;
}

std::vector<std::uint64_t> hashesOf(World& world, int steps) {
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < steps; ++i) {
        world.step();
        hashes.push_back(world.hash());
    }
    return hashes;
}

}  // namespace

TEST_CASE("a world on a foreign task runner goes through the same states") {
    for (const PlanSolver solver : {PlanSolver::Exact, PlanSolver::Fast}) {
        const WorldDef def = floorBy(solver, 11);
        Result<World> own = World::create(def);
        REQUIRE(own.ok());
        const std::vector<std::uint64_t> expected = hashesOf(*own, 40);
        for (const TaskRunner& runner :
             {TaskRunner{2, nullptr, backwards}, TaskRunner{3, nullptr, threadsOfItsOwn}}) {
            RunnerLog log;
            Result<World> world = World::create(def, TaskRunner{runner.threads, &log, runner.run});
            REQUIRE(world.ok());
            CHECK(hashesOf(*world, 40) == expected);
            CHECK(log.runs > 0);
        }
    }
}

TEST_CASE("a snapshot goes on on a foreign task runner as it would on threads") {
    for (const PlanSolver solver : {PlanSolver::Exact, PlanSolver::Fast}) {
        Result<World> world = World::create(floorBy(solver, 12), 2);
        REQUIRE(world.ok());
        hashesOf(*world, 25);
        const std::vector<std::uint8_t> saved = world->snapshot();
        RunnerLog log;
        Result<World> restored = World::restore(saved, TaskRunner{2, &log, backwards});
        REQUIRE(restored.ok());
        CHECK(restored->hash() == world->hash());
        CHECK(hashesOf(*restored, 30) == hashesOf(*world, 30));
        CHECK(log.items > 0);
    }
}

TEST_CASE("a runner that cannot run is refused by name") {
    const WorldDef def = testing::openFloor();
    const Result<World> none = World::create(def, TaskRunner{2, nullptr, nullptr});
    REQUIRE_FALSE(none.ok());
    CHECK(none.status().message() == "runner: found no function, expected one that runs tasks");
    RunnerLog log;
    for (const std::int32_t threads : {0, -1, 257}) {
        const Result<World> few = World::create(def, TaskRunner{threads, &log, backwards});
        REQUIRE_FALSE(few.ok());
        CHECK(few.status().message() ==
              "runner: found " + std::to_string(threads) + " threads, expected 1 to 256");
        CHECK_FALSE(World::restore({}, TaskRunner{threads, &log, backwards}).ok());
    }
}

TEST_CASE("the totals of walks are those of the last plan") {
    WorldDef def = testing::openFloor(3);
    def.groups[0].starts = {{-9, 0}, {-9, 2}, {-9, -3}};
    Result<World> made = World::create(def);
    REQUIRE(made.ok());
    World& world = *made;
    world.step();
    WalkTotals expected;
    for (std::size_t i = 0; i < 3; ++i) {
        // On an open floor the path is straight; the field of the grid lengthens it a little.
        const Vec2 place = world.group(0).placePositions[world.characters().place[i]];
        const double walk = length(place - def.groups[0].starts[i]);
        expected.sum += walk;
        expected.squares += walk * walk;
        expected.longest = std::max(expected.longest, walk);
    }
    const WalkTotals& walk = world.group(0).walk;
    CHECK(walk.sum == doctest::Approx(expected.sum).epsilon(0.05));
    CHECK(walk.squares == doctest::Approx(expected.squares).epsilon(0.1));
    CHECK(walk.longest == doctest::Approx(expected.longest).epsilon(0.05));
    CHECK(walk.squares >= walk.longest * walk.longest);
    CHECK(walk.sum * walk.sum >= walk.squares);
}

TEST_CASE("totals of walks: the infinite do not count, others are added") {
    WalkTotals a, b;
    a.add(3.0);
    a.add(std::numeric_limits<double>::infinity());
    b.add(4.0);
    b.add(1.0);
    a.add(b);
    CHECK(a.sum == 8.0);
    CHECK(a.squares == 26.0);
    CHECK(a.longest == 4.0);
}
