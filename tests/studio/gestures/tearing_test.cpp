// Two fingers one after the other, and the schemes that lack some of what fingers do.
#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Two fingers come down on sixteen people, 3 m apart; the second one later than the window.
void takeOneByOne(DrivenWorld& driven) {
    driven.down(1, {0.5, -1.5});
    driven.run(0.3);
    driven.down(2, {0.5, 1.5});
    driven.run(0.1);
}

/// Two fingers come down together and are spread to 7 m.
void spread(DrivenWorld& driven) {
    driven.down(1, {0.5, -1.5});
    driven.down(2, {0.5, 1.5});
    driven.run(0.2);
    driven.glide({{1, {0.5, -3.5}}, {2, {0.5, 3.5}}}, 2.0);
    driven.run(0.5);
}

void pullApart(DrivenWorld& driven, double apart) {
    driven.glide({{1, {0.5, -0.5 * apart}}, {2, {0.5, 0.5 * apart}}}, 1.0);
}

}  // namespace

TEST_CASE("Two fingers one after the other tear a formation, and each goes on with its part") {
    DrivenWorld driven(sixteen(), "touch");
    takeOneByOne(driven);
    pullApart(driven, 12.0);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.world.group(0).members.size() == 8);
    CHECK(driven.world.group(1).members.size() == 8);
    REQUIRE(driven.world.group(0).controls.size() == 1);
    REQUIRE(driven.world.group(1).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].points.size() == 1);
    CHECK(driven.world.group(1).controls[0].points.size() == 1);
    const std::size_t upper = driven.middle(0).y > driven.middle(1).y ? 0 : 1;
    driven.glide({{1, {4.5, -6}}, {2, {-3.5, 6}}}, 2.0);
    driven.up(1);
    driven.up(2);
    driven.run(6.0);
    CHECK(distance(driven.middle(upper), {-4, 5.5}) < 0.8);
    CHECK(distance(driven.middle(1 - upper), {4, -5.5}) < 0.8);
    CHECK(driven.world.groupCount() == 2);
}

TEST_CASE("Shorter pulls tear nothing: 1.6 times as far and 2 spacings more are needed") {
    DrivenWorld driven(sixteen(), "touch");
    takeOneByOne(driven);
    pullApart(driven, 4.9);  // More than 1.6 times as far, but not 2 m more.
    CHECK(driven.world.groupCount() == 1);
    pullApart(driven, 5.1);
    driven.step();
    CHECK(driven.world.groupCount() == 2);
    DrivenWorld wide(floorWith({squareOf(36, {0, 0})}), "touch");
    wide.down(1, {0.5, -2.5});
    wide.run(0.3);
    wide.down(2, {0.5, 2.5});
    wide.run(0.1);
    pullApart(wide, 7.9);  // More than 2 m more, but not 1.6 times as far.
    CHECK(wide.world.groupCount() == 1);
    pullApart(wide, 8.1);
    wide.step();
    CHECK(wide.world.groupCount() == 2);
}

TEST_CASE("One pull tears a formation once, however fast each finger moves") {
    for (const double down : {3.0, 4.0, 5.0, 6.0}) {
        CAPTURE(down);
        DrivenWorld driven(floorWith({squareOf(36, {0, 0})}), "touch");
        takeOneByOne(driven);
        driven.glide({{1, {0.5, -1.5 - down}}, {2, {0.5, 2.5}}}, 0.5);
        driven.run(0.2);
        CHECK(driven.world.groupCount() == 2);
        CHECK(driven.refused.empty());
    }
}

TEST_CASE("A formation is torn between the fingers, on the perpendicular bisector") {
    DrivenWorld driven(sixteen(), "touch");
    driven.down(1, {0.5, -1.5});
    driven.run(0.3);
    driven.down(2, {0.5, 0.5});  // The bisector lies at y = -0.5, just below the third rank from above.
    driven.run(0.1);
    std::vector<std::uint32_t> lower;
    for (const std::uint32_t id : driven.members(0))
        if (driven.positionOf(id).y < -1.0) lower.push_back(id);
    REQUIRE(lower.size() == 4);
    driven.glide({{1, {0.5, -2.5}}, {2, {0.5, 1.7}}}, 0.4);
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 2);
    const std::size_t torn = driven.world.group(0).members.size() < 8 ? 0 : 1;
    for (const std::uint32_t id : lower) {
        const auto ids = driven.members(torn);
        CHECK(std::find(ids.begin(), ids.end(), id) != ids.end());
    }
}

TEST_CASE("A formation that has gone on with its fingers is still torn between them") {
    DrivenWorld driven(floorWith({squareOf(16, {0, -5})}), "touch");
    driven.down(1, {0.5, -6.5});
    driven.run(0.3);
    driven.down(2, {0.5, -3.5});
    driven.run(0.1);
    driven.glide({{1, {0.5, -0.5}}, {2, {0.5, 2.5}}}, 5.0);
    driven.run(1.0);
    REQUIRE(driven.world.groupCount() == 1);
    driven.glide({{1, {0.5, -2.5}}, {2, {0.5, 4.5}}}, 1.0);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.world.group(0).members.size() == 8);
    CHECK(driven.world.group(1).members.size() == 8);
}

TEST_CASE("A part that was torn off is torn again by its finger and another one") {
    DrivenWorld driven(sixteen(), "touch");
    takeOneByOne(driven);
    pullApart(driven, 5.2);
    driven.run(3.0);
    REQUIRE(driven.world.groupCount() == 2);
    for (const std::uint32_t finger : {1u, 2u}) {
        CAPTURE(finger);
        const double side = finger == 1 ? -1.0 : 1.0;
        const Vec2 person = driven.positionOf(driven.nearestTo({-1.5, side * 2.0}));
        driven.down(3, person);
        driven.run(0.3);
        driven.glide({{3, person - Vec2{4, 0}}}, 1.0);
        driven.up(3);
        driven.run(0.5);
        CHECK(driven.world.groupCount() == 2 + finger);
    }
}

TEST_CASE("Two fingers that came down together tear nothing") {
    DrivenWorld driven(sixteen(), "touch");
    spread(driven);
    CHECK(driven.world.groupCount() == 1);
    CHECK(driven.formation().files == 8);
}

TEST_CASE("touch-no-shapes keeps lines, areas and widths off, and still tears") {
    DrivenWorld driven(sixteen(), "touch-no-shapes");
    spread(driven);
    CHECK(driven.formation().files == 0);
    CHECK(driven.extent().y < 4.5);
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].kind == ControlKind::Point);
    DrivenWorld three(sixteen(), "touch-no-shapes");
    three.down(1, {0.5, -1.5});
    three.down(2, {0.5, 1.5});
    three.down(3, {-1.5, 0.5});
    three.run(0.3);
    REQUIRE(three.world.group(0).controls.size() == 1);
    CHECK(three.world.group(0).controls[0].points.size() == 1);
    DrivenWorld torn(sixteen(), "touch-no-shapes");
    takeOneByOne(torn);
    pullApart(torn, 6.0);
    CHECK(torn.world.groupCount() == 2);
}

TEST_CASE("touch-no-shapes gives no square back, since it takes none") {
    WorldDef def = sixteen();
    def.groups[0].formation.files = 8;
    DrivenWorld driven(def, "touch-no-shapes");
    driven.tapTwice(driven.positionOf(1));
    CHECK(driven.formation().files == 8);
}

TEST_CASE("touch-no-splits tears, cuts and takes out nothing, and still widens") {
    DrivenWorld driven(sixteen(), "touch-no-splits");
    takeOneByOne(driven);
    pullApart(driven, 8.0);
    driven.up(1);
    driven.up(2);
    driven.run(1.0);
    CHECK(driven.world.groupCount() == 1);
    DrivenWorld cut(sixteen(), "touch-no-splits");
    cut.draw({{-4, 0}, {4, 0}}, 0.5);
    CHECK(cut.world.groupCount() == 1);
    CHECK(cut.marks().stroke.empty());
    cut.draw({{-4, -4}, {-4, 0}, {0, 0}, {0, -4}, {-3.8, -4}}, 0.3);
    CHECK(cut.world.groupCount() == 1);
    DrivenWorld wide(sixteen(), "touch-no-splits");
    spread(wide);
    CHECK(wide.formation().files == 8);
}

TEST_CASE("touch-no-splits joins nothing") {
    DrivenWorld driven(floorWith({squareOf(4, {-2, 0}), squareOf(4, {2, 0})}), "touch-no-splits");
    driven.draw({{-4, -3}, {4, -3}, {4, 3}, {-4, 3}, {-4, -2.8}}, 0.3);
    CHECK(driven.world.groupCount() == 2);
}

TEST_CASE("touch-one-finger lets other fingers do nothing") {
    DrivenWorld driven(sixteen(), "touch-one-finger");
    spread(driven);
    CHECK(driven.formation().files == 0);
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].points.size() == 1);
    DrivenWorld torn(sixteen(), "touch-one-finger");
    takeOneByOne(torn);
    pullApart(torn, 8.0);
    CHECK(torn.world.groupCount() == 1);
    torn.down(3, {6, 6});
    torn.step();
    CHECK(torn.marks().stroke.empty());
    DrivenWorld cut(sixteen(), "touch-one-finger");
    cut.draw({{-4, 0}, {4, 0}}, 0.5);
    CHECK(cut.world.groupCount() == 2);
}
