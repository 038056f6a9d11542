// Marches against what can be reckoned: times of straight ways and turns, bounds on speed and acceleration.
#include "engine/orders/march.h"

#include <doctest.h>

#include "base/maths.h"

using namespace muster;

namespace {

constexpr double kStep = 1.0 / 60.0;

MarchDef plain(Turn turn = Turn::Wheel) {
    MarchDef def;
    def.turn = turn;
    def.speed = 2.0;
    def.acceleration = 4.0;
    def.reach = 5.0;
    def.depth = 2.0;
    return def;
}

March along(std::vector<Vec2> way) {
    March march;
    march.way = std::move(way);
    march.next = 1;
    march.phase = MarchPhase::Go;
    return march;
}

struct Walked {
    double seconds = 0.0;
    double fastest = 0.0;     ///< Of the middle [m/s].
    double fastestRim = 0.0;  ///< Of the farthest place [m/s].
    double jerk = 0.0;        ///< Largest change of the middle's speed per time [m/s^2].
    Pose end;
};

Walked follow(const MarchDef& def, March& march, Pose pose, double most = 200.0) {
    Walked course;
    double before = 0.0;
    while (march.phase != MarchPhase::Stand && course.seconds < most) {
        const Pose next = advanceMarch(def, march, pose, kStep);
        const double speed = distance(next.position, pose.position) / kStep;
        course.fastest = std::max(course.fastest, speed);
        for (int k = 0; k < 16; ++k) {
            const Vec2 rim = Vec2{cosine(k * kPi / 8), sine(k * kPi / 8)} * def.reach;
            course.fastestRim = std::max(course.fastestRim,
                                         distance(next.apply(rim), pose.apply(rim)) / kStep);
        }
        course.jerk = std::max(course.jerk, std::fabs(speed - before) / kStep);
        before = speed;
        pose = next;
        course.seconds += kStep;
    }
    course.end = pose;
    return course;
}

}  // namespace

TEST_CASE("a straight march takes its length over its speed and one ramp, and is at rest at the end") {
    March march = along({{0, 0}, {40, 0}});
    const Walked course = follow(plain(), march, Pose{});
    // Ramps up and down take v / a together more than the length at full speed.
    CHECK(course.seconds == doctest::Approx(40.0 / 2.0 + 2.0 / 4.0).epsilon(0.02));
    CHECK(course.end.position == Vec2{40, 0});
    CHECK(course.fastest <= 2.0 + 1e-9);
    CHECK(march.phase == MarchPhase::Stand);
    CHECK(course.seconds == doctest::Approx(marchTime(plain(), march.way, {1, 0}, {})).epsilon(0.03));
}

TEST_CASE("no place is faster than the bound where a march wheels") {
    for (int k = 0; k < 12; ++k) {
        const double angle = -kPi + 0.1 + k * kPi / 6.0;
        const Vec2 corner{15, 0};
        March march = along({{0, 0}, corner, corner + Vec2{cosine(angle), sine(angle)} * 20.0});
        march.turns = true;
        march.facing = angle;
        const Walked course = follow(plain(), march, Pose{});
        CAPTURE(angle);
        CHECK(course.fastestRim <= 2.0 + 1e-6);
        CHECK(distance(course.end.position, march.way.back()) < 1e-9);
        CHECK(course.end.rotation.c == doctest::Approx(cosine(angle)).epsilon(1e-6));
        CHECK(course.seconds < marchTime(plain(), march.way, {1, 0}, angle) + 6.0);
        CHECK(course.seconds > 35.0 / 2.0);
    }
}

TEST_CASE("half a turn takes at least the time of the rim, and stays on the spot") {
    March march;
    march.phase = MarchPhase::Turn;
    march.turns = true;
    march.facing = kPi;
    const Walked course = follow(plain(), march, Pose{});
    CHECK(course.seconds >= kPi * 5.0 / 2.0);
    CHECK(course.seconds <= kPi * 5.0 / 2.0 + 3.0);
    CHECK(course.end.position == Vec2{});
    CHECK(course.end.rotation.c == doctest::Approx(-1.0));
}

TEST_CASE("who reverses does not turn, and faces back") {
    March march = along({{0, 0}, {-20, 0}});
    const Walked course = follow(plain(Turn::Reverse), march, Pose{});
    CHECK(march.reversed);
    CHECK(course.end.rotation.c == doctest::Approx(1.0));
    CHECK(march.front(course.end).x == doctest::Approx(-1.0));
    CHECK(course.seconds == doctest::Approx(20.0 / 2.0 + 0.5).epsilon(0.02));
}

TEST_CASE("who keeps its facing never turns, whatever the way") {
    March march = along({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}});
    const Walked course = follow(plain(Turn::Keep), march, Pose{});
    CHECK(course.end.rotation.c == 1.0);
    CHECK(course.end.position == Vec2{});
    CHECK(course.seconds == doctest::Approx(40.0 / 2.0 + 0.5).epsilon(0.02));
}

TEST_CASE("a march stands while the crowd is too far behind") {
    March march = along({{0, 0}, {40, 0}});
    MarchDef def = plain();
    Pose pose;
    for (int s = 0; s < 120; ++s) pose = advanceMarch(def, march, pose, kStep);
    def.pace = 0.0;
    for (int s = 0; s < 60; ++s) pose = advanceMarch(def, march, pose, kStep);
    const Vec2 stands = pose.position;
    for (int s = 0; s < 60; ++s) pose = advanceMarch(def, march, pose, kStep);
    CHECK(pose.position == stands);
    CHECK(march.speed == 0.0);
}

TEST_CASE("ways of no length and of doubled corners end") {
    for (const std::vector<Vec2>& way : {std::vector<Vec2>{{0, 0}, {0, 0}}, std::vector<Vec2>{{0, 0}},
                                         std::vector<Vec2>{{0, 0}, {5, 0}, {5, 0}, {5, 0}}}) {
        March march = along(way);
        const Walked course = follow(plain(), march, Pose{}, 30.0);
        CHECK(march.phase == MarchPhase::Stand);
        CHECK(course.end.position == way.back());
    }
}
