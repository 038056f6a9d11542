// Two taps on people make a widened formation square again.
#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Sixteen people in two ranks of eight.
WorldDef wideSixteen() {
    WorldDef def = floorWith({squareOf(16, {0, 0})});
    def.groups[0].formation.files = 8;
    return def;
}

}  // namespace

TEST_CASE("Two taps on people make their formation square again") {
    DrivenWorld driven(wideSixteen(), "touch");
    CHECK(driven.extent().y == doctest::Approx(7.0).epsilon(0.05));
    driven.tapTwice(driven.positionOf(5));
    CHECK(driven.formation().kind == FormationKind::Square);
    CHECK(driven.formation().files == 0);
    driven.run(6.0);
    CHECK(driven.extent().y == doctest::Approx(3.0).epsilon(0.1));
    CHECK(driven.extent().x == doctest::Approx(3.0).epsilon(0.1));
    CHECK(distance(driven.middle(), {0, 0}) < 0.3);
    CHECK(driven.world.group(0).controls.empty());
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("A formation of another shape becomes a square of its spacing, too") {
    WorldDef def = floorWith({squareOf(16, {0, 0}, 1.2)});
    def.groups[0].formation.kind = FormationKind::Wedge;
    DrivenWorld driven(def, "touch");
    driven.tapTwice(driven.positionOf(5));
    CHECK(driven.formation().kind == FormationKind::Square);
    CHECK(driven.formation().spacing == 1.2);
}

TEST_CASE("One tap changes nothing") {
    DrivenWorld driven(wideSixteen(), "touch");
    const auto before = driven.positions();
    driven.tap(driven.positionOf(5));
    driven.run(1.0);
    CHECK(driven.formation().files == 8);
    CHECK(driven.farthestFrom(before) < 0.1);
    CHECK(driven.world.group(0).controls.empty());
}

TEST_CASE("What a tap draws is not followed after it lifts") {
    DrivenWorld driven(wideSixteen(), "touch");
    const auto before = driven.positions();
    const Vec2 person = driven.positionOf(5);
    driven.draw({person, person + Vec2{0, 0.34}}, 0.1);  // 3.8 mm; people walk half of it meanwhile.
    driven.run(2.0);
    CHECK(driven.farthestFrom(before) < 0.25);
    CHECK(driven.world.group(0).controls.empty());
}

TEST_CASE("Two taps are within 0.4 s of each other") {
    DrivenWorld late(wideSixteen(), "touch");
    late.tapTwice(late.positionOf(5), late.positionOf(5), 0.4);
    CHECK(late.formation().files == 8);
    DrivenWorld soon(wideSixteen(), "touch");
    soon.tapTwice(soon.positionOf(5), soon.positionOf(5), 0.28);
    CHECK(soon.formation().files == 0);
}

TEST_CASE("Two taps are within 8 mm of each other on the display") {
    DrivenWorld far(wideSixteen(), "touch");
    const Vec2 first = far.positionOf(5);
    const Vec2 second = far.positionOf(far.nearestTo(first + Vec2{0, 4}));
    REQUIRE(distance(first, second) > 2.0);
    far.tapTwice(first, second);
    CHECK(far.formation().files == 8);
    // 5 mm are 0.45 m there.
    DrivenWorld near(wideSixteen(), "touch");
    near.tapTwice(near.positionOf(5), near.positionOf(5) + Vec2{0.45, 0});
    CHECK(near.formation().files == 0);
}

TEST_CASE("A press that lasts 0.35 s or moves 4 mm is no tap") {
    DrivenWorld slow(wideSixteen(), "touch");
    slow.tap(slow.positionOf(5));
    slow.tap(slow.positionOf(5), 0.36);
    CHECK(slow.formation().files == 8);
    DrivenWorld moved(wideSixteen(), "touch");
    const Vec2 person = moved.positionOf(5);
    moved.tap(person);
    moved.draw({person, person + Vec2{0.4, 0}, person}, 0.05);
    CHECK(moved.formation().files == 8);
    DrivenWorld hardly(wideSixteen(), "touch");
    hardly.tap(person);
    hardly.draw({person, person + Vec2{0.3, 0}, person}, 0.05);
    CHECK(hardly.formation().files == 0);
}

TEST_CASE("Taps on two formations, and cancelled ones, count for neither") {
    WorldDef def = wideSixteen();
    def.groups.push_back(squareOf(9, {5, 0}));
    def.groups[1].formation.files = 9;
    DrivenWorld driven(def, "touch");
    driven.tapTwice(driven.positionOf(5), driven.positionOf(20));
    CHECK(driven.formation(0).files == 8);
    CHECK(driven.formation(1).files == 9);
    DrivenWorld cancelled(def, "touch");
    for (int i = 0; i < 2; ++i) {
        cancelled.down(1, cancelled.positionOf(5));
        cancelled.run(0.05);
        cancelled.cancel(1);
        cancelled.run(0.05);
    }
    CHECK(cancelled.formation(0).files == 8);
}

TEST_CASE("What counts as a tap follows the display, not the ground") {
    // At 10 pixels for a metre 0.35 m are 1 mm, and 2 m are 5.6 mm.
    DrivenWorld driven(wideSixteen(), "touch", 10.0);
    const Vec2 person = driven.positionOf(5);
    driven.draw({person, person + Vec2{0.9, 0}}, 0.05);
    driven.draw({person + Vec2{0.9, 0}, person}, 0.05);
    CHECK(driven.formation().files == 0);
}
