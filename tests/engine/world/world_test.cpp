// The step as a whole: crowds follow their mesh, keep apart, and obey commands.
#include "muster/world.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"
#include "muster/views.h"

using namespace muster;
using namespace muster::testing;

namespace {

double worstDistanceToPlace(const World& world) {
    double worst = 0.0;
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.place[i] < 0) continue;
        const auto places = world.group(c.group[i]).placePositions;
        worst = std::max(worst, distance(c.position[i], places[c.place[i]]));
    }
    return worst;
}

int countEvents(World& world, double seconds, EventKind kind) {
    int n = 0;
    const int steps = static_cast<int>(std::lround(seconds / world.parameters().stepTime));
    for (int s = 0; s < steps; ++s) {
        world.step();
        for (const Event& event : world.events()) n += event.kind == kind ? 1 : 0;
    }
    return n;
}

using Watch = std::function<void(const World&)>;

// Drags the whole mesh by two corners over `travel` at 1.5 m/s and lifts.
void drag(
    World& world, Vec2 travel, const Watch& watch = [](const World&) {}) {
    const auto mesh = world.group(0).finalMesh;
    const Vec2 a = mesh.front();
    const Vec2 b = mesh.back();
    REQUIRE(give(world, Touch{TouchPhase::Down, 1, a, world.time(), {}}).ok());
    REQUIRE(give(world, Touch{TouchPhase::Down, 2, b, world.time(), {}}).ok());
    const int steps = static_cast<int>(length(travel) / 1.5 * 60.0);
    for (int s = 1; s <= steps; ++s) {
        world.step();
        watch(world);
        const Vec2 offset = travel * (static_cast<double>(s) / steps);
        REQUIRE(give(world, Touch{TouchPhase::Move, 1, a + offset, world.time(), {}}).ok());
        REQUIRE(give(world, Touch{TouchPhase::Move, 2, b + offset, world.time(), {}}).ok());
    }
    REQUIRE(give(world, Touch{TouchPhase::Up, 1, {}, world.time(), {}}).ok());
    REQUIRE(give(world, Touch{TouchPhase::Up, 2, {}, world.time(), {}}).ok());
}

}  // namespace

TEST_CASE("a crowd that stands in its places stays there without a swap") {
    World world = World::create(openFloor(36)).value();
    const auto before = copyOf(world.characters().position);
    CHECK(countEvents(world, 3.0, EventKind::Swap) == 0);
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(distance(before[i], world.characters().position[i]) < 1e-6);
}

TEST_CASE("two fingers drag the crowd across the floor; all arrive and swaps are rare") {
    World world = World::create(openFloor(36)).value();
    drag(world, {12, 0});
    run(world, 6.0);
    CHECK(worstDistanceToPlace(world) < 0.1);
    double mean = 0.0;
    for (const Vec2 p : world.characters().position) mean += p.x / 36.0;
    CHECK(mean == doctest::Approx(6.0).epsilon(0.03));
    CHECK(world.group(0).controls.empty());
}

TEST_CASE("the crowd parts round a block and is whole again behind it") {
    WorldDef def = openFloor(36);
    def.obstacles.push_back(block(-1.5, -1.5, 1.5, 1.5));
    World world = World::create(def).value();
    drag(world, {13, 0});
    run(world, 8.0);
    CHECK(worstDistanceToPlace(world) < 0.25);
    for (const Vec2 p : world.characters().position) {
        CHECK(p.x > 2.0);
        CHECK(inspect::environment(world).distanceToObstacle(p) > 0.25 - 1e-6);
    }
}

TEST_CASE("with the opposing force the mesh waits for a crowd held up, without it it does not") {
    const auto lagAfter = [](bool enabled) {
        WorldDef def = openFloor(25);
        def.patches.push_back(rectangle(-3.5, -10, 10, 10, 3));
        def.parameters.opposing.enabled = enabled;
        World world = World::create(def).value();
        drag(world, {12, 0});
        run(world, 1.0);
        return world.group(0).meanLag;
    };
    CHECK(lagAfter(true) < 0.6 * lagAfter(false));
}

TEST_CASE("every formation is taken up and nobody is left over") {
    WorldDef def = openFloor(40);
    def.box = {{-24, -24}, {24, 24}};
    World world = World::create(def).value();
    for (int kind = 0; kind < 8; ++kind) {
        FormationDef formation{.kind = static_cast<FormationKind>(kind)};
        REQUIRE(give(world, ChangeGroup{.group = world.group(0).id, .formation = formation}).ok());
        run(world, 14.0);
        CAPTURE(kind);
        CHECK(world.rejections().empty());
        CHECK(worstDistanceToPlace(world) < 0.25);
        for (const std::int32_t place : world.characters().place) CHECK(place >= 0);
    }
}

TEST_CASE("characters may join and leave while it runs") {
    World world = World::create(openFloor(20)).value();
    REQUIRE(give(world, ChangeGroup{.group = world.group(0).id, .count = 35}).ok());
    run(world, 10.0);
    CHECK(world.characters().size() == 35);
    CHECK(worstDistanceToPlace(world) < 0.25);
    REQUIRE(give(world, ChangeGroup{.group = world.group(0).id, .count = 7}).ok());
    run(world, 10.0);
    CHECK(world.characters().size() == 7);
    CHECK(world.characters().id.back() == 7);
    CHECK(worstDistanceToPlace(world) < 0.25);
}

TEST_CASE("patches slow, are reported as events, and set the motion id") {
    WorldDef def = openFloor(16);
    def.patches.push_back(rectangle(-3, -11, 0, 11, 3));
    World world = World::create(def).value();
    int entered = 0;
    int left = 0;
    double fastest = 0.0;
    const Watch watch = [&](const World& now) {
        for (const Event& event : now.events()) {
            entered += event.kind == EventKind::EnterPatch ? 1 : 0;
            left += event.kind == EventKind::LeavePatch ? 1 : 0;
        }
        const CharactersView c = now.characters();
        for (std::size_t i = 0; i < c.size(); ++i)
            if (c.position[i].x > -2.8 && c.position[i].x < -0.2)
                fastest = std::max(fastest, length(c.velocity[i]));
    };
    drag(world, {12, 0}, watch);
    for (int s = 0; s < 60 * 60; ++s) {
        world.step();
        watch(world);
    }
    CHECK(entered >= 16);
    CHECK(left >= 16);
    const double speed = inspect::environment(world).def().clips[3].speed *
                         world.parameters().character.maxSpeed;
    CHECK(fastest <= speed * 1.0001);
    CHECK(fastest > speed * 0.9);
    CHECK(worstDistanceToPlace(world) < 0.25);
}

TEST_CASE("items are collected once and checkpoints change the formation") {
    WorldDef def = openFloor(16);
    def.items = {{{0, 0}, 0.5}, {{11, 11}, 0.5}};
    def.checkpoints.push_back({.position = {0, 0}, .formation = {.kind = FormationKind::Column}});
    World world = World::create(def).value();
    int collected = 0;
    int changed = 0;
    const Watch watch = [&](const World& now) {
        for (const Event& event : now.events()) {
            collected += event.kind == EventKind::Collect ? 1 : 0;
            changed += event.kind == EventKind::FormationChange ? 1 : 0;
        }
    };
    drag(world, {9, 0}, watch);
    for (int s = 0; s < 60 * 12; ++s) {
        world.step();
        watch(world);
    }
    CHECK(collected == 1);
    CHECK(world.collected()[0] == 1);
    CHECK(world.collected()[1] == 0);
    CHECK(changed == 1);
    CHECK(world.group(0).formation == FormationKind::Column);
}

TEST_CASE("bad commands are refused with a sentence and change nothing") {
    World world = World::create(openFloor(9)).value();
    World other = World::create(openFloor(9)).value();
    CHECK_FALSE(world.submit({0, 1, 0, Touch{TouchPhase::Down, 1, {NAN, 0}, 0.0, {}}}).ok());
    CHECK(give(world, ChangeGroup{.group = GroupId{99}, .formation = FormationDef{}}).ok());
    CHECK(give(world, removeThing(ObstacleId{5})).ok());
    CHECK(give(world, Touch{TouchPhase::Up, 4, {}, 0.0, {}}).ok());
    CHECK(give(world, Touch{TouchPhase::Down, 1, {11, 11}, 0.0, {}}).ok());
    world.step();
    other.step();
    CHECK(world.rejections().size() == 4);
    for (const Rejection& rejection : world.rejections()) CHECK_FALSE(rejection.status.message().empty());
    CHECK(world.hash() == other.hash());
    CHECK_FALSE(world.submit({0, 1, 9, ReleaseClient{}}).ok());
}

TEST_CASE("plan modes: fixed keeps places, assigned once keeps the first assignment") {
    for (const PlanMode mode : {PlanMode::AssignedOnce, PlanMode::Fixed}) {
        WorldDef def = openFloor(25);
        def.parameters.plan.mode = mode;
        World world = World::create(def).value();
        world.step();
        const auto first = copyOf(world.characters().place);
        drag(world, {8, 3});
        CHECK(countEvents(world, 5.0, EventKind::Swap) == 0);
        CHECK(copyOf(world.characters().place) == first);
        CHECK(worstDistanceToPlace(world) < 0.25);
    }
}

TEST_CASE("worlds of nonsense are refused by name") {
    WorldDef def = openFloor(0);
    CHECK_FALSE(World::create(def).ok());
    def = openFloor(4);
    def.groups[0].starts = {{0, 0}};
    const auto starts = World::create(def);
    CHECK_FALSE(starts.ok());
    CHECK(starts.status().message().find("groups[0]") != std::string::npos);
    def = openFloor(4);
    def.obstacles.push_back(block(0, 0, 0, 0));
    const auto flat = World::create(def);
    CHECK_FALSE(flat.ok());
    CHECK(flat.status().message().find("obstacles[0]") != std::string::npos);
    def = openFloor(4);
    def.cell = -1;
    CHECK_FALSE(World::create(def).ok());
}
