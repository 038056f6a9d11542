// One finger, two fingers, three fingers on formations.
#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

bool holdsFinger(const DrivenWorld& driven, std::size_t group = 0) {
    for (const Control& control : driven.world.group(group).controls)
        for (const ControlPoint& point : control.points)
            if (point.down) return true;
    return false;
}

/// Two fingers come down together on both sides of sixteen people.
void takeSides(DrivenWorld& driven, Vec2 half) {
    driven.down(1, half * -1.0);
    driven.run(0.05);
    driven.down(2, half);
    driven.run(0.2);
}

}  // namespace

TEST_CASE("One finger drags a formation, which follows the drawn way to its end after the finger lifts") {
    DrivenWorld driven(sixteen({-5.5, -2.5}), "touch");
    driven.draw({{-6, -3}, {-6, 3}, {1, 3}}, 0.5);
    CHECK(distance(driven.middle(), {-5.5, -2.5}) < 2.0);  // The hand was much faster than people walk.
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].kind == ControlKind::Point);
    CHECK(!holdsFinger(driven));
    double fromCorner = 1e9;
    for (int i = 0; i < 120; ++i) {
        driven.run(0.1);
        fromCorner = std::min(fromCorner, distance(driven.middle(), {-5.5, 3.5}));
    }
    CHECK(fromCorner < 0.8);
    CHECK(distance(driven.middle(), {1.5, 3.5}) < 0.3);
    CHECK(driven.world.group(0).controls.empty());
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("A finger that is drawn on leads at once, whatever the camera sees of the ground") {
    DrivenWorld driven(sixteen(), "touch", 12.0);
    driven.draw({{0.5, 0.5}, {0.5, 6.5}}, 5.0);
    driven.run(4.0);
    CHECK(distance(driven.middle(), {0, 6}) < 0.3);
}

TEST_CASE("A new finger on people ends the ways that their formation follows") {
    DrivenWorld driven(sixteen({-5.5, -0.5}), "touch");
    driven.draw({{-6, -1}, {4, -1}}, 0.5);
    driven.run(1.5);
    const ControlId old = driven.world.group(0).controls[0].id;
    driven.down(1, driven.positionOf(driven.members(0)[5]));
    driven.step();
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].id != old);
    CHECK(holdsFinger(driven));
    const Vec2 there = driven.middle();
    driven.run(0.6);
    driven.up(1);
    driven.run(6.0);
    CHECK(distance(driven.middle(), there) < 0.8);
    CHECK(driven.middle().x < 1.0);
}

TEST_CASE("Where nobody stands under it a finger takes hold once it is no tap any more") {
    DrivenWorld driven(floorWith({squareOf(16, {-4, 0}, 3.0)}), "touch");
    const auto press = [&](const char* how) {
        CAPTURE(how);
        driven.draw({driven.positionOf(driven.members(0)[0]), {-4, 6}}, 0.3);
        driven.run(0.5);
        const Vec2 between = driven.world.group(0).pose.position;
        REQUIRE(distance(driven.positionOf(driven.nearestTo(between)), between) > 0.7);
        driven.down(2, between);
        driven.run(0.2);
        CHECK(!holdsFinger(driven));
        CHECK(driven.world.group(0).controls.size() == 1);
        return between;
    };
    press("by resting");
    driven.run(0.2);
    CHECK(holdsFinger(driven));
    CHECK(driven.world.group(0).controls.size() == 1);
    driven.up(2);
    driven.run(3.0);
    CHECK(driven.world.group(0).controls.empty());
    const Vec2 between = press("by moving");
    driven.move(2, between + Vec2{0.4, 0});
    driven.step();
    CHECK(holdsFinger(driven));
    CHECK(driven.world.group(0).controls.size() == 1);
}

TEST_CASE("Two fingers together widen a square, and narrow it again") {
    DrivenWorld driven(sixteen(), "touch");
    takeSides(driven, {0, 1.5});
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].kind == ControlKind::Line);
    driven.glide({{1, {0, -3.5}}, {2, {0, 3.5}}}, 2.0);
    driven.run(3.0);
    CHECK(driven.formation().files == 8);
    CHECK(driven.extent().y == doctest::Approx(7.0).epsilon(0.08));
    CHECK(driven.extent().x < 1.8);
    driven.glide({{1, {0, -1.5}}, {2, {0, 1.5}}}, 2.0);
    driven.run(3.0);
    CHECK(driven.formation().files == 4);
    CHECK(driven.extent().y == doctest::Approx(3.0).epsilon(0.15));
    driven.up(1);
    driven.up(2);
    driven.run(3.0);
    CHECK(driven.formation().files == 4);
    CHECK(distance(driven.middle(), {0, 0}) < 0.5);
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("Fingers that come down behind each other set the ranks") {
    DrivenWorld driven(sixteen(), "touch");
    takeSides(driven, {1.5, 0});
    driven.glide({{1, {-3.5, 0}}, {2, {3.5, 0}}}, 2.0);
    driven.run(3.0);
    CHECK(driven.formation().files == 2);
    CHECK(driven.extent().x == doctest::Approx(7.0).epsilon(0.08));
}

TEST_CASE("The number of files changes once it is wrong by 0.7, at most every 0.15 s") {
    DrivenWorld driven(sixteen(), "touch");
    takeSides(driven, {0, 1.5});
    driven.glide({{1, {0, -1.8}}, {2, {0, 1.8}}}, 0.5);
    CHECK(driven.formation().files == 0);
    driven.glide({{1, {0, -1.87}}, {2, {0, 1.87}}}, 0.1);
    CHECK(driven.formation().files == 5);
    double last = -1.0;
    int changes = 0;
    for (int s = 0; s < 60; ++s) {
        const std::int32_t before = driven.formation().files;
        const double half = 1.87 + 0.06 * s;
        driven.move(1, {0, -half});
        driven.move(2, {0, half});
        driven.step();
        if (driven.formation().files == before) continue;
        if (changes++ > 0) CHECK(driven.world.time() - last >= 0.15 - 1e-9);
        last = driven.world.time();
    }
    CHECK(changes >= 3);
}

TEST_CASE("Fingers that have drawn a way more than 3 m ahead of the people no longer set the width") {
    DrivenWorld driven(sixteen({-6, 0}), "touch");
    driven.down(1, {-6, -1.5});
    driven.down(2, {-6, 1.5});
    driven.run(0.2);
    driven.glide({{1, {0, -1.5}}, {2, {0, 1.5}}}, 0.3);
    driven.glide({{1, {0, -3.5}}, {2, {0, 3.5}}}, 0.3);
    CHECK(driven.formation().files == 0);
    CHECK(driven.middle().x < -3.5);
}

TEST_CASE("Three fingers together make an area") {
    DrivenWorld driven(sixteen({-3, 0}), "touch");
    const std::map<std::uint32_t, Vec2> from{{1, {-4.5, -1.5}}, {2, {-4.5, 1.5}}, {3, {-1.5, 0.5}}};
    std::map<std::uint32_t, Vec2> to;
    for (const auto& [finger, ground] : from) {
        driven.down(finger, ground);
        driven.run(0.03);
        to[finger] = ground + Vec2{4, 2};
    }
    driven.run(0.2);
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].kind == ControlKind::Area);
    CHECK(driven.world.group(0).controls[0].points.size() == 3);
    driven.glide(to, 3.0);
    for (const auto& [finger, ground] : to) driven.up(finger);
    driven.run(3.0);
    CHECK(distance(driven.middle(), {1, 2}) < 0.3);
    CHECK(driven.formation().files == 0);
    CHECK(driven.world.groupCount() == 1);
}
