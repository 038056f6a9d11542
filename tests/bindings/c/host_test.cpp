// The host's job system under a world; every shipped scenario through C.
#include <doctest.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "bindings/c/both_worlds.h"
#include "muster/scenario.h"
#include "test_folders.h"

using namespace muster;

namespace {

/// A job system of two workers in plain functions, as a C program would write it.
struct Jobs {
    std::atomic<int> rounds{0};
    std::atomic<int> launches{0};
    std::thread background;
};

void runJobs(void* context, std::int32_t count, MusterTask task, void* taskContext) {
    ++static_cast<Jobs*>(context)->rounds;
    std::atomic<std::int32_t> next{0};
    const auto work = [&](std::int32_t worker) {
        for (std::int32_t item = next++; item < count; item = next++) task(taskContext, item, worker);
    };
    std::thread other(work, 1);
    work(0);
    other.join();
}
void launchJob(void* context, MusterBackgroundTask task, void* taskContext) {
    auto& jobs = *static_cast<Jobs*>(context);
    ++jobs.launches;
    jobs.background = std::thread(task, taskContext);
}
void waitForJob(void* context) {
    static_cast<Jobs*>(context)->background.join();
}

MusterTaskRunner runnerOf(Jobs& jobs) {
    MusterTaskRunner runner = muster_default_task_runner();
    runner.threads = 2;
    runner.context = &jobs;
    runner.run = runJobs;
    runner.launch = launchJob;
    runner.wait = waitForJob;
    return runner;
}

/// A crowd that is large enough to be work for two.
WorldDef largeDef() {
    return {.box = {{-32, -32}, {32, 32}}, .groups = {{.count = 400}}};
}

std::uint64_t hashOf(MusterWorldId world) {
    std::uint64_t hash = 0;
    CHECK(muster_world_hash(world, &hash) == MUSTER_OK);
    return hash;
}

}  // namespace

TEST_SUITE("the host of the C API") {
    TEST_CASE(
        "a world on the host's jobs is the same as on one thread, from a definition and from a snapshot") {
        c_api::Arena arena;
        const WorldDef def = largeDef();
        const MusterWorldDef same = asC<MusterWorldDef>(def, arena);
        Jobs jobs, others;
        const MusterTaskRunner runner = runnerOf(jobs), otherRunner = runnerOf(others);
        MusterWorldId world{}, restored{};
        REQUIRE(muster_world_create_on(&same, &runner, &world) == MUSTER_OK);
        World engine = *World::create(def);
        const Command order{0, 1, 0, SetPose{{1}, {12, 0}, 0.0}};
        const MusterCommand given = asC<MusterCommand>(order, arena);
        CHECK(muster_world_submit(world, &given) == MUSTER_OK);
        CHECK(engine.submit(order).ok());
        for (int step = 0; step < 30; ++step) {
            CHECK(muster_world_step(world) == MUSTER_OK);
            engine.step();
        }
        CHECK(hashOf(world) == engine.hash());
        MusterBuffer bytes{};
        REQUIRE(muster_world_snapshot(world, &bytes) == MUSTER_OK);
        REQUIRE(muster_world_restore_on(bytes.data, bytes.size, &otherRunner, &restored) == MUSTER_OK);
        muster_free_buffer(&bytes);
        for (int step = 0; step < 10; ++step) {
            CHECK(muster_world_step(restored) == MUSTER_OK);
            engine.step();
        }
        CHECK(hashOf(restored) == engine.hash());
        CHECK(muster_world_destroy(world) == MUSTER_OK);
        CHECK(muster_world_destroy(restored) == MUSTER_OK);
        CHECK(jobs.rounds > 0);
        CHECK(jobs.launches > 0);
        CHECK(others.rounds > 0);
    }

    TEST_CASE("times and contacts of a step are there, and name its stages") {
        BothWorlds both(makeDef());
        both.step();
        const MusterStageTime* stages = nullptr;
        std::int32_t count = 0;
        double total = -1.0;
        REQUIRE(muster_world_stage_times(both.id(), &stages, &count, &total) == MUSTER_OK);
        REQUIRE(count == static_cast<int>(kStageCount));
        double sum = 0.0;
        for (std::int32_t i = 0; i < count; ++i) {
            CHECK(std::string(stages[i].name) == stepStages()[i].name.data());
            sum += stages[i].milliseconds;
        }
        CHECK(sum <= total);
        MusterContacts contacts{-1, -1.0};
        REQUIRE(muster_world_contacts(both.id(), &contacts) == MUSTER_OK);
        CHECK(contacts.overlapPairs == both.engine().contacts().overlapPairs);
        CHECK(contacts.worstPenetration == both.engine().contacts().worstPenetration);
        double seconds = 0.0;
        CHECK(muster_world_time(both.id(), &seconds) == MUSTER_OK);
        CHECK(seconds == both.engine().time());
        std::uint32_t step = 7;
        CHECK(muster_world_last_command_step(both.id(), &step) == MUSTER_OK);
        CHECK(step == 0);
    }

    TEST_CASE("queues, controls and definitions of groups are those of the engine") {
        BothWorlds both(makeDef());
        const auto script = sampleScript(both.engine());
        CHECK(both.submit({0, 1, 0, script[0].second}) == MUSTER_OK);
        CHECK(both.submit({0, 1, 1, GiveOrder{{2}, QueueMode::Append, 0, Order::face(0.75)}}) == MUSTER_OK);
        for (int step = 0; step < 3; ++step) both.step();
        std::int32_t index = -1, count = 0;
        CHECK(muster_world_group_index(both.id(), 2, &index) == MUSTER_OK);
        REQUIRE(index == 1);
        CHECK(muster_world_group_index(both.id(), 5, &index) == MUSTER_NOT_FOUND);
        const MusterQueuedOrder* orders = nullptr;
        REQUIRE(muster_world_group_orders(both.id(), 1, &orders, &count) == MUSTER_OK);
        const GroupView view = both.engine().group(1);
        REQUIRE(count == static_cast<int>(view.orders.size()));
        REQUIRE(count == 2);
        CHECK(orders[0].id == view.orders[0].id);
        REQUIRE(orders[0].order.formation != nullptr);
        CHECK(orders[0].order.formation->kind == MUSTER_FORMATION_LINE);
        CHECK(orders[1].order.kind == MUSTER_ORDER_FACE);
        CHECK(orders[1].order.facing == 0.75);
        const MusterControl* controls = nullptr;
        REQUIRE(muster_world_group_controls(both.id(), 0, &controls, &count) == MUSTER_OK);
        const GroupView touched = both.engine().group(0);
        REQUIRE(count == static_cast<int>(touched.controls.size()));
        REQUIRE(count == 1);
        CHECK(controls[0].client == 1);
        REQUIRE(controls[0].pointCount == 1);
        CHECK(controls[0].points[0].vertex == touched.controls[0].points[0].vertex);
        CHECK(controls[0].points[0].position.x == touched.controls[0].points[0].position.x);
        MusterGroupDef def = muster_default_group_def();
        REQUIRE(muster_world_group_def(both.id(), 0, &def) == MUSTER_OK);
        CHECK(std::string(def.name) == "First");
        REQUIRE(def.roleCount == 1);
        CHECK(def.roles[0].area == MUSTER_ROLE_FRONT);
        REQUIRE(def.bodyCount >= 1);
        CHECK(def.bodies[0].mass == 2.0);
    }

    TEST_CASE("every shipped scenario comes through C unchanged") {
        std::size_t scenarios = 0;
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(sourceFolder() + "/scenarios")) {
            if (entry.path().extension() != ".json") continue;
            const Result<WorldDef> def = loadScenario(entry.path().string());
            if (!def.ok()) continue;  // Gestures, which are not scenarios.
            CAPTURE(entry.path().string());
            c_api::Arena arena;
            const MusterWorldDef same = asC<MusterWorldDef>(*def, arena);
            WorldDef back;
            REQUIRE(c_api::readC(&same, back, "def").ok());
            CHECK(writeScenario(back) == writeScenario(*def));
            ++scenarios;
        }
        CHECK(scenarios > 10);
    }
}
