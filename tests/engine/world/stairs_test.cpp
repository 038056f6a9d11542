// Stairs and ramps: speeds up, down and across, of the patch and of single persons; and a corridor.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/stairs.h"
#include "engine/world/played.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

// One person in a corridor of 2 m, 60 m long, who goes from x = -29 to 29, or back.
WorldDef corridor(double speed, double towards) {
    WorldDef def{.box = {{-32, -1}, {32, 1}}};
    GroupDef group{.count = 1, .position = {-29.0 * towards, 0.0}};
    group.bodies = {{.maxSpeed = speed}};
    group.orders = {Order::go({29.0 * towards, 0.0})};
    def.groups.push_back(group);
    return def;
}

PatchDef stairs(double x0, double x1, double up, double down) {
    PatchDef patch = rectangle(x0, -1, x1, 1, 0);
    patch.speed = up;
    patch.speedDown = down;
    patch.ascent = 0.0;
    return patch;
}

// The time between two positions along x [s], by the straight line between steps.
double timeBetween(const WorldDef& def, double from, double to) {
    Played played(def);
    const double sign = to > from ? 1.0 : -1.0;
    double began = -1.0, before = played.world.characters().position[0].x;
    for (int s = 0; s < 60 * 200; ++s) {
        const double time = played.world.time(), dt = played.world.parameters().stepTime;
        played.run(dt);
        const double now = played.world.characters().position[0].x;
        const auto at = [&](double x) { return time + dt * (x - before) / (now - before); };
        if (began < 0.0 && sign * now >= sign * from) began = at(from);
        if (sign * now >= sign * to) return at(to) - began;
        before = now;
    }
    return 1e9;
}

}  // namespace

TEST_CASE("a corridor of 40 m takes 30 s at 1.33 m/s, and with the start from rest little more") {
    WorldDef def = corridor(1.33, 1.0);
    CHECK(timeBetween(def, -20.0, 20.0) == doctest::Approx(40.0 / 1.33).epsilon(1e-3));
    // From rest: RiMEA 1 allows 26 to 34 s.
    const double whole = timeBetween(def, -28.999, 11.001);
    CHECK(whole > 40.0 / 1.33);
    CHECK(whole < 40.0 / 1.33 + 0.5);
    def.groups[0].bodies[0].maxSpeed = 1.0;
    CHECK(timeBetween(def, -20.0, 20.0) == doctest::Approx(40.0).epsilon(1e-3));
}

TEST_CASE("ten metres of stairs take their time up and down") {
    struct Case {
        double speed, up, down, own;  // `own`: the share of the person for both; 0 for none.
        double timeUp, timeDown;
    };
    for (const Case& c : {Case{1.0, 1.0, 1.0, 0.0, 10.0, 10.0},  // IMO 2 and 3.
                          {1.0, 0.5, -1.0, 0.0, 20.0, 20.0},
                          {1.33, 0.5, 0.65, 0.0, 10.0 / 0.665, 10.0 / 0.8645},
                          {1.33, 0.5, 0.8, 0.3, 10.0 / 0.399, 10.0 / 0.399},
                          {1.0, 0.5, 0.8, 1.0, 10.0, 10.0}}) {
        WorldDef def = corridor(c.speed, 1.0);
        def.patches = {stairs(-5, 5, c.up, c.down)};
        def.groups[0].bodies[0].upstairs = def.groups[0].bodies[0].downstairs = c.own;
        CAPTURE(c.up);
        CAPTURE(c.own);
        CHECK(timeBetween(def, -5.0, 5.0) == doctest::Approx(c.timeUp).epsilon(5e-3));
        def.groups[0].position.x = 29.0;
        def.groups[0].orders = {Order::go({-29.0, 0.0})};
        CHECK(timeBetween(def, 5.0, -5.0) == doctest::Approx(c.timeDown).epsilon(5e-3));
    }
}

TEST_CASE("a march goes up and down stairs at their speeds") {
    for (const bool up : {true, false}) {
        WorldDef def = corridor(1.0, up ? 1.0 : -1.0);
        def.patches = {stairs(-5, 5, 0.5, 0.8)};
        def.groups[0].orders[0].manner = Manner::March;
        const double time = up ? timeBetween(def, -5.0, 5.0) : timeBetween(def, 5.0, -5.0);
        CHECK(time == doctest::Approx(10.0 / (up ? 0.5 : 0.8)).epsilon(0.05));  // Marches go at 0.97.
    }
}

TEST_CASE("own shares of stairs hold on stairs alone, and one of them leaves the other to the stairs") {
    WorldDef def = corridor(1.0, 1.0);
    def.patches = {rectangle(-5, -1, 5, 1, 0)};
    def.patches[0].speed = 0.5;
    def.groups[0].bodies[0].upstairs = 0.2;
    CHECK(timeBetween(def, -5.0, 5.0) == doctest::Approx(20.0).epsilon(5e-3));
    def.patches[0].ascent = kPi;  // Down, for who comes from the left.
    CHECK(timeBetween(def, -5.0, 5.0) == doctest::Approx(20.0).epsilon(5e-3));
    def.patches[0].ascent = 0.0;
    CHECK(timeBetween(def, -5.0, 5.0) == doctest::Approx(50.0).epsilon(5e-3));
}

TEST_CASE("between up and down the time for a metre goes with the cosine of the direction") {
    EnvironmentDef def;
    Environment environment = Environment::create(def).value();
    PatchDef patch = stairs(-5, 5, 0.5, 0.8);
    patch.ascent = 0.7;
    REQUIRE(environment.addPatch(patch).ok());
    const GroundSample ground = environment.ground({0, 0});
    const auto along = [&](double angle) {
        return ground.speedAlong({cosine(0.7 + angle), sine(0.7 + angle)});
    };
    const double mean = 2.0 / (1.0 / 0.5 + 1.0 / 0.8);
    CHECK(along(0.0) == doctest::Approx(0.5));
    CHECK(along(kPi) == doctest::Approx(0.8));
    CHECK(along(0.5 * kPi) == doctest::Approx(mean));
    CHECK(ground.travelSpeed == doctest::Approx(mean));
    CHECK(ground.speedAlong({}) == doctest::Approx(mean));
    CHECK(environment.travelSpeed()[environment.grid().index(environment.grid().nearestCell({0, 0}))] ==
          doctest::Approx(mean));
    double slowness = 0.0;
    for (int k = 0; k < 3600; ++k) {
        const double here = along(k * kPi / 1800.0), next = along((k + 1) * kPi / 1800.0);
        CHECK(std::fabs(next - here) < 1e-3);
        CHECK(here >= 0.5);
        CHECK(here <= doctest::Approx(0.8));
        slowness += 1.0 / here / 3600.0;
    }
    CHECK(1.0 / slowness == doctest::Approx(mean));
    CHECK(environment.ground({0, 3}).speedAlong({1, 0}) == 1.0);
    Body slow{.downstairs = 0.2};
    CHECK(travelSpeedOf(ground, slow, {cosine(0.7), sine(0.7)}) == doctest::Approx(0.5));
    CHECK(travelSpeedOf(ground, slow, {-cosine(0.7), -sine(0.7)}) == doctest::Approx(0.2));
    CHECK(travelSpeedOf(environment.ground({0, 3}), slow, {1, 0}) == 1.0);
}

TEST_CASE("stairs turn with a patch that moves, and bad numbers are refused") {
    Environment environment;
    PatchDef patch = stairs(-5, 5, 0.5, 1.0);
    patch.path.waypoints = {{0, {0, 0}, 0}, {10, {0, 0}, 0.5 * kPi}};
    REQUIRE(environment.addPatch(patch).ok());
    environment.setTime(10.0);
    CHECK(environment.ground({0, 0}).speedAlong({0, 1}) == doctest::Approx(0.5));
    CHECK(environment.ground({0, 0}).speedAlong({0, -1}) == doctest::Approx(1.0));
    patch.speedDown = 0.0;
    CHECK_FALSE(environment.addPatch(patch).ok());
    patch.speedDown = 0.5;
    patch.ascent = std::nan("");
    CHECK_FALSE(environment.addPatch(patch).ok());
}

TEST_CASE("a crowd goes up and down stairs at once, and a snapshot goes on bit for bit") {
    WorldDef def{.box = {{-20, -4}, {20, 4}}, .patches = {rectangle(-4, -4, 4, 4, 0)}};
    def.patches[0].speed = 0.5;
    def.patches[0].speedDown = 0.7;
    def.patches[0].ascent = 0.0;
    for (const double side : {-1.0, 1.0}) {
        GroupDef group{.count = 16, .position = {14.0 * side, 0.0}, .people = {adults()}};
        group.people[0].downstairs = 0.6;
        group.orders = {Order::move({-14.0 * side, 0.0})};
        def.groups.push_back(group);
    }
    Played played(def);
    played.run(12.0);
    checkGoesOn(played.world, 300);
    played.run(60.0);
    CHECK(played.farthest(0) < 0.5);
    CHECK(played.farthest(1) < 0.5);
    CHECK(played.deepest < 0.1);
}
