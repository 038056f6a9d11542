// The mesh by one mouse and keys.
#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr Modifiers kAlt{false, false, true};
constexpr char kDelete = 127;

std::span<const Control> controlsOf(const DrivenWorld& driven) {
    return driven.world.group(0).controls;
}

/// Shift draws a line through sixteen people, from below to above.
void drawLine(DrivenWorld& driven) {
    driven.modifiers = kShift;
    driven.draw({{0, -1.5}, {0, 1.5}}, 0.3);
    driven.modifiers = {};
    driven.run(0.1);
}

/// Ctrl draws a loop round their middle.
void drawArea(DrivenWorld& driven) {
    driven.modifiers = kControl;
    driven.draw({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -0.8}}, 0.2);
    driven.modifiers = {};
    driven.run(0.1);
}

void key(DrivenWorld& driven, char name) {
    driven.key(name);
    driven.step();
}

}  // namespace

TEST_CASE("A drag with the mouse moves a point, which is followed to its end") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    driven.draw({{0.5, 0.5}, {5.5, 3.5}}, 0.5);
    REQUIRE(controlsOf(driven).size() == 1);
    CHECK(controlsOf(driven)[0].kind == ControlKind::Point);
    driven.run(8.0);
    CHECK(distance(driven.middle(), {5, 3}) < 0.3);
    CHECK(controlsOf(driven).empty());
}

TEST_CASE("Shift drags a line, whose ends can be dragged then") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    drawLine(driven);
    REQUIRE(controlsOf(driven).size() == 1);
    CHECK(controlsOf(driven)[0].kind == ControlKind::Line);
    REQUIRE(controlsOf(driven)[0].points.size() == 2);
    const double before = driven.extent().y;
    driven.draw({{0, 1.5}, {0, 4.5}}, 1.0);
    driven.run(4.0);
    REQUIRE(controlsOf(driven).size() == 1);
    CHECK(controlsOf(driven)[0].points[1].position.y - controlsOf(driven)[0].points[0].position.y > 5.0);
    CHECK(driven.extent().y > before + 1.5);
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("With Alt the whole line goes along") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    drawLine(driven);
    driven.modifiers = kAlt;
    driven.draw({{0, 1.5}, {4, 3.5}}, 1.0);
    driven.modifiers = {};
    driven.run(5.0);
    CHECK(distance(driven.middle(), {4, 2}) < 0.4);
    CHECK(driven.extent().y < 3.5);
}

TEST_CASE("Ctrl draws the loop of an area with six points") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    drawArea(driven);
    REQUIRE(controlsOf(driven).size() == 1);
    CHECK(controlsOf(driven)[0].kind == ControlKind::Area);
    CHECK(controlsOf(driven)[0].points.size() == 6);
    driven.modifiers = kAlt;
    driven.draw({{-1, -1}, {3, 0}}, 1.0);
    driven.modifiers = {};
    driven.run(5.0);
    CHECK(distance(driven.middle(), {4, 1}) < 0.4);
}

TEST_CASE("P pins and releases, Delete removes, Escape lets all go") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    drawLine(driven);
    key(driven, 'P');
    REQUIRE(controlsOf(driven).size() == 1);
    CHECK(controlsOf(driven)[0].pinned);
    key(driven, 'P');
    CHECK(!controlsOf(driven)[0].pinned);
    key(driven, kDelete);
    CHECK(controlsOf(driven).empty());
    drawLine(driven);
    REQUIRE(controlsOf(driven).size() == 1);
    driven.run(2.0);
    CHECK(controlsOf(driven).size() == 1);  // It is held until it is let go.
    key(driven, kEscape);
    driven.run(1.0);
    CHECK(controlsOf(driven).empty());
    CHECK(driven.refused.empty());
}

TEST_CASE("A new drag on people lets the old line go") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    drawLine(driven);
    driven.draw({{-1.5, 0.5}, {-6.5, 0.5}}, 0.5);
    driven.run(7.0);
    CHECK(controlsOf(driven).empty());
    CHECK(distance(driven.middle(), {-5, 0}) < 0.4);
}

TEST_CASE("A stroke of the mouse on free ground cuts, a loop joins") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    driven.draw({{-4, 0}, {4, 0}}, 0.3);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(0).size() == 8);
    CHECK(driven.marks().stroke.empty());
    driven.draw({{-4, -4}, {4, -4}, {4, 4}, {-4, 4}, {-4, -3.8}}, 0.2);
    CHECK(driven.world.groupCount() == 1);
    CHECK(driven.members(0).size() == 16);
    driven.draw({{-4, 0}, {-2.5, 0}}, 0.2);
    CHECK(driven.world.groupCount() == 1);
    CHECK(!driven.marks().notice.empty());
}

TEST_CASE("Other buttons than the left one do nothing to the mesh") {
    DrivenWorld driven(sixteen(), "mouse-mesh");
    driven.button = PointerButton::Right;
    driven.draw({{0.5, 0.5}, {5.5, 0.5}}, 0.5);
    driven.draw({{-4, 0}, {4, 0}}, 0.3);
    CHECK(controlsOf(driven).empty());
    CHECK(driven.world.groupCount() == 1);
}
