// What the experiments measure with: checked where the answer is known.
#include <doctest.h>

#include <cmath>

#include "base/random.h"
#include "engine/geometry/polygon.h"
#include "lab/reproduce/experiments/car_watch.h"
#include "lab/reproduce/experiments/encounter_watch.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/ground_watch.h"

using namespace muster;

namespace {

constexpr MotionId kDuck = 2;
constexpr MotionId kJump = 5;

// One character, that starts at `start` and wants to be at the origin.
WorldDef onePerson(Vec2 start) {
    return {.groups = {{.count = 1,
                        .formation = {.kind = FormationKind::Points, .points = {{0.0, 0.0}}},
                        .starts = {start}}}};
}

Polygon rectangle(Vec2 min, Vec2 max) {
    return {min, {max.x, min.y}, max, {min.x, max.y}};
}

}  // namespace

TEST_CASE("rays and the library agree on what lies inside") {
    const Polygon star{{0, 3},    {-0.7, 1},   {-2.9, 0.9}, {-1.1, -0.4}, {-1.8, -2.4},
                       {0, -1.2}, {1.8, -2.4}, {1.1, -0.4}, {2.9, 0.9},   {0.7, 1}};
    Random random(4);
    int inside = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec2 p{random.uniform(-3.2, 3.2), random.uniform(-3.2, 3.2)};
        CHECK(rayCastInside(star, p) == containsPoint(star, p));
        inside += rayCastInside(star, p) ? 1 : 0;
    }
    CHECK(inside > 3000);
}

TEST_CASE("stays in a mouse's polygon are counted once each, and as the events tell") {
    // It runs over the character, leaves it for the given time, and comes back. Edges are never just at the
    // character.
    for (const double away : {0.3, 0.8}) {
        WorldDef def = onePerson({0, 0});
        PatchDef mouse{.polygon = rectangle({-1, -1}, {1, 1}), .motion = kJump};
        const double out = 1.0 + 0.5 * away;  // From the edge at x = 1 and back, at 1 m/s.
        mouse.path.waypoints = {{0.0, {-3.004, 0}, 0.0},
                                {3.0 + out, {out - 0.004, 0}, 0.0},
                                {3.0 + 2.0 * out, {-0.004, 0}, 0.0},
                                {20.0, {-0.004, 0}, 0.0}};
        def.patches.push_back(mouse);
        World world = *World::create(def);
        EncounterWatch watch(world, kJump);
        while (world.time() < 8.0) {
            world.step();
            watch.observe(world);
        }
        const int expected = away > 0.5 ? 2 : 1;
        CHECK(watch.encounters() == expected);
        CHECK(watch.events() == expected);
        CHECK(watch.byCharacter()[0] == expected);
        CHECK(watch.mismatches() == 0);
    }
}

TEST_CASE("way, time and speed on slow ground") {
    WorldDef def = onePerson({-6, 0});
    def.patches.push_back({.polygon = rectangle({-4, -16}, {-1, 16}), .motion = kDuck});
    World world = *World::create(def);
    GroundWatch watch(world);
    CHECK(std::isnan(watch.speed(kDuck)));
    while (world.time() < 12.0) {
        world.step();
        watch.observe(world);
    }
    CHECK(distance(world.characters().position[0], {0, 0}) < 0.05);
    // 3 m at 0.4 x 2 m/s; braking at the edge is a little quicker, and the steps over the edges do not count.
    CHECK(watch.metres(kDuck) == doctest::Approx(3.0).epsilon(0.03));
    CHECK(watch.seconds(kDuck) == doctest::Approx(3.75).epsilon(0.06));
    CHECK(watch.speed(kDuck) == doctest::Approx(watch.metres(kDuck) / watch.seconds(kDuck)));
    CHECK(watch.visitors(kDuck) == 1);
    CHECK(watch.visitors(kJump) == 0);
    CHECK(watch.wrongShare(kDuck) == 0.0);
}

TEST_CASE("the gap to a passing car, and a mesh that gives way to it") {
    for (const double strength : {0.0, 2.0}) {
        WorldDef def = onePerson({0, 0});
        def.obstacles.push_back({.polygon = rectangle({-2, 1}, {2, 2}),
                                 .path = {.waypoints = {{0.0, {-8, 0}, 0.0}, {8.0, {8, 0}, 0.0}}},
                                 .range = 2.0,
                                 .strength = strength});
        World world = *World::create(def);
        CarWatch watch(world);
        while (world.time() < 8.0) {
            world.step();
            watch.observe(world);
        }
        if (strength == 0.0) {
            CHECK(watch.smallest() == doctest::Approx(1.0 - def.parameters.character.radius));
            CHECK(watch.meanSmallest() == doctest::Approx(1.0 - def.parameters.character.radius));
            CHECK(std::isnan(watch.givesWayFrom()));
        } else {
            CHECK(watch.smallest() > 1.0);
            // 0.1 m are 2 (1 - d / 2): from 1.9 m on, and a little nearer as the mesh takes its time.
            CHECK(watch.givesWayFrom() < 1.9);
            CHECK(watch.givesWayFrom() > 1.2);
        }
        CHECK(watch.nearer(0.8) == (strength == 0.0 ? 1 : 0));
    }
}

TEST_CASE("a contact leaves no gap") {
    WorldDef def = onePerson({0, 0});
    def.parameters.field.enabled = false;
    def.parameters.character.maxSpeed = 0.01;  // Cannot get away.
    def.obstacles.push_back({.polygon = rectangle({-2, -0.5}, {2, 0.7}),
                             .path = {.waypoints = {{0.0, {-6, 0}, 0.0}, {6.0, {6, 0}, 0.0}}}});
    World world = *World::create(def);
    CarWatch watch(world);
    while (world.time() < 6.0) {
        world.step();
        watch.observe(world);
    }
    CHECK(watch.smallest() <= 1e-6);
    CHECK(watch.smallest() > -0.1);
}

TEST_CASE("a hand that draws aside") {
    std::vector<Command> commands(4);
    commands[0].body = Touch{TouchPhase::Down, 1, {0, 0}, 1.0, {}};
    commands[1].body = Touch{TouchPhase::Move, 1, {1, 0}, 1.0, {}};
    commands[2].body = Touch{TouchPhase::Move, 1, {2, 0}, 2.0, {}};
    commands[3].body = Touch{TouchPhase::Move, 1, {3, 0}, 9.0, {}};
    const std::vector<Command> before = commands;
    jitterHand(commands, 7, 0.0);
    for (std::size_t k = 1; k < 4; ++k)
        CHECK(std::get<Touch>(commands[k].body).position == std::get<Touch>(before[k].body).position);
    jitterHand(commands, 7, 0.4);
    const auto shift = [&](std::size_t k) {
        return std::get<Touch>(commands[k].body).position - std::get<Touch>(before[k].body).position;
    };
    CHECK(std::get<Touch>(commands[0].body).position == Vec2{0, 0});
    CHECK(shift(1) == Vec2{});
    CHECK(distance(shift(2) * 2.0, shift(3)) < 1e-12);
    CHECK(std::fabs(shift(3).x) <= 0.4);
    CHECK(std::fabs(shift(3).y) <= 0.4);
    CHECK(length(shift(3)) > 0.0);
    std::vector<Command> other = before;
    jitterHand(other, 8, 0.4);
    CHECK(std::get<Touch>(other[3].body).position != std::get<Touch>(commands[3].body).position);
}
