// The choice of ways as state: saved, hashed, switched off, and steady.
#include <doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "engine/passages/way_number.h"
#include "engine/steering/character_arrays.h"
#include "engine/world/inspect.h"
#include "engine/world/world_engine.h"
#include "engine/world/world_scenes.h"
#include "jams/jam_run.h"
#include "muster/scenario.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Sixty before a door of 1 m, a gap of 3 m beside it.
JamScene smallJam() {
    WallPlan plan{.openings = {{-0.5, 0.5}, {6.0, 9.0}},
                  .crowd = {-8, 0},
                  .goal = {8, 0},
                  .count = 60,
                  .box = {{-20, -16}, {20, 16}}};
    return sceneOf(plan);
}

/// A world with all commands of the scene queued.
World startOf(const JamScene& scene, std::int32_t threads = 1) {
    World world = World::create(scene.def, threads).value();
    for (const Command& command : scene.commands) REQUIRE(world.submit(command).ok());
    return world;
}

void stepTo(World& world, double time) {
    while (world.time() < time) world.step();
}

int onWays(const World& world) {
    int count = 0;
    for (const ChosenWay& chosen : inspect::characters(world).chosen) count += chosen.way >= 0 ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("a saved jam continues bit for bit, before, while and after ways are chosen") {
    World world = startOf(smallJam());
    for (const double time : {1.5, 2.3, 3.1, 4.2, 6.0, 9.0}) {
        stepTo(world, time);
        testing::checkGoesOn(world, 45);
    }
}

TEST_CASE("a jam saved in each step of a survey continues bit for bit, as does one rewound to there") {
    // So many people that the survey takes several steps.
    WallPlan plan{.openings = {{-22.0, -20.0}, {-12.0, -9.0}, {-0.5, 0.5}, {6.0, 9.0}, {16.0, 18.0}},
                  .crowd = {-16, 0},
                  .goal = {16, 0},
                  .count = 900,
                  .box = {{-32, -36}, {32, 36}}};
    const JamScene scene = sceneOf(plan);
    World world = startOf(scene), later = startOf(scene);
    stepTo(later, 2.0);
    int searching = 0, solving = 0;
    while (world.time() < 8.0 && solving < 3) {
        world.step();
        const SurveyPhase phase = WorldAccess::of(world).state.survey.phase;
        searching += phase == SurveyPhase::Search;
        solving += phase == SurveyPhase::Fields;
        if (phase == SurveyPhase::None) continue;
        World copy = World::restore(world.snapshot()).value();
        REQUIRE(later.rewind(world.snapshot()).ok());
        CHECK(copy.snapshot() == world.snapshot());
        World plain = World::restore(world.snapshot()).value();
        for (int s = 0; s < 6; ++s) {
            plain.step();
            copy = World::restore(copy.snapshot()).value();
            copy.step();
            later.step();
            REQUIRE(copy.hash() == plain.hash());
            REQUIRE(later.hash() == plain.hash());
        }
    }
    CHECK(searching > 0);
    CHECK(solving > 0);
}

TEST_CASE("a jam does not depend on the number of threads") {
    const JamScene scene = smallJam();
    World one = startOf(scene), three = startOf(scene, 3);
    for (int s = 0; s < 420; ++s) {
        one.step();
        three.step();
        if (s % 30 == 0) REQUIRE(one.hash() == three.hash());
    }
    CHECK(one.hash() == three.hash());
}

TEST_CASE("without a command nobody changes the passage more than once; all are through in the end") {
    const JamScene scene = smallJam();
    World world = startOf(scene);
    stepTo(world, 3.9);
    CHECK(onWays(world) >= 50);
    std::map<std::size_t, std::size_t> passage;
    std::map<std::size_t, int> changes;
    while (world.time() < 30.0) {
        world.step();
        const std::vector<ChosenWay>& chosen = inspect::characters(world).chosen;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (chosen[i].way < 0) continue;
            const auto [known, fresh] = passage.try_emplace(i, passageOf(chosen[i].way));
            if (!fresh && known->second != passageOf(chosen[i].way)) ++changes[i];
            known->second = passageOf(chosen[i].way);
        }
    }
    for (const auto& [character, count] : changes) CHECK(count <= 1);
    CHECK(onWays(world) == 0);
    for (const Vec2 p : world.characters().position) CHECK(p.x > 2.0);
}

TEST_CASE("where the switch is off, nobody has a way; switched off in between, all lose theirs") {
    JamScene scene = smallJam();
    World world = startOf(scene);
    stepTo(world, 5.0);
    CHECK(onWays(world) > 0);
    REQUIRE(world.submit({world.stepCount(), 2, 0, SetParameter{"plan.waits", 0.0}}).ok());
    world.step();
    CHECK(onWays(world) == 0);
    scene.def.parameters.plan.waits = false;
    const JamRun without = runJam(scene);
    scene.def.parameters.plan.waits = true;
    const JamRun with = runJam(scene);
    CHECK(without.through[1] < with.through[1]);
    CHECK(with.through[1] >= 20);
    CHECK(with.last < 0.85 * without.last);
}

TEST_CASE("ground that changes is looked at again") {
    const JamScene scene = smallJam();
    World world = startOf(scene);
    stepTo(world, 4.5);
    CHECK(onWays(world) > 0);
    // The gap is walled up: all take the door.
    REQUIRE(world.submit({world.stepCount(), 2, 0, putThing(wallPart(WallPlan{}, 5.5, 9.5))}).ok());
    world.step();
    stepTo(world, 45.0);
    CHECK(onWays(world) == 0);
    for (const Vec2 p : world.characters().position) CHECK(p.x > 2.0);
}

TEST_CASE("in the open and where there is room nobody looks for passages") {
    WallPlan plan{.openings = {{-12.0, 12.0}},
                  .crowd = {-8, 0},
                  .goal = {8, 0},
                  .count = 60,
                  .box = {{-20, -16}, {20, 16}}};
    const JamScene scene = sceneOf(plan);
    World world = startOf(scene);
    for (int s = 0; s < 600; ++s) {
        world.step();
        REQUIRE(onWays(world) == 0);
    }
}

TEST_CASE("before a narrow alley between two climbs some climb rather than wait, and none past the alley") {
    const std::string path = sourceFolder() + "/scenarios/paper/x08-congestion.json";
    JamScene scene{.def = loadScenario(path).value()};
    scene.commands = loadScenarioGestures(path, scene.def).value();
    // The alley is found first.
    const auto isClimb = [](std::int32_t way) { return way >= 0 && passageOf(way) != 0; };
    World world = startOf(scene);
    std::vector<ChosenWay> before(36);
    std::set<std::size_t> climbers;
    while (world.time() < 25.0) {
        world.step();
        const std::vector<ChosenWay>& chosen = inspect::characters(world).chosen;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const Vec2 p = world.characters().position[i];
            if (std::fabs(p.x) < 0.5 && std::fabs(p.y) > 2.0) climbers.insert(i);
            // From one climb to the other one walks past the alley.
            const bool both = isClimb(chosen[i].way) && isClimb(before[i].way);
            if (p.x > -4.0) CHECK_FALSE((both && chosen[i].way != before[i].way));
            before[i] = chosen[i];
        }
    }
    CHECK(climbers.size() >= 4);
    for (const Vec2 p : world.characters().position) CHECK(p.x > 2.0);
}
