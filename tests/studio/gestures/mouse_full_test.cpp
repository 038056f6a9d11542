// A mouse that selects and sends: what strategy players expect, and the paper's figure 12.
#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

using Ids = std::vector<std::uint32_t>;

WorldDef ninesApart() {
    return floorWith({squareOf(9, {-4, 0}), squareOf(9, {4, 0})});
}

void box(DrivenWorld& driven, Vec2 from, Vec2 to, Modifiers modifiers = {}) {
    driven.modifiers = modifiers;
    driven.draw({from, to}, 0.2);
    driven.modifiers = {};
}

void click(DrivenWorld& driven, Vec2 ground, Modifiers modifiers = {}) {
    driven.modifiers = modifiers;
    driven.tap(ground);
    driven.modifiers = {};
}

void sendTo(DrivenWorld& driven, Vec2 ground, Modifiers modifiers = {}) {
    driven.button = PointerButton::Right;
    click(driven, ground, modifiers);
    driven.button = PointerButton::Left;
}

void press(DrivenWorld& driven, char name, Modifiers modifiers = {}) {
    driven.modifiers = modifiers;
    driven.key(name);
    driven.modifiers = {};
    driven.step();
}

/// Ids of those in a box of the ground, ascending.
Ids idsIn(const DrivenWorld& driven, Vec2 least, Vec2 most) {
    Ids ids;
    for (const std::uint32_t id : driven.world.characters().id)
        if (Box{least, most}.contains(driven.positionOf(id))) ids.push_back(id);
    return ids;
}

}  // namespace

TEST_CASE("A box selects those in it, and shows while it is drawn") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    driven.down(1, {-3, -3});
    driven.move(1, {0, 3});
    REQUIRE(driven.marks().rectangle.size() == 4);
    CHECK(distance(driven.marks().rectangle[2], {0, 3}) < 1e-6);
    driven.up(1);
    CHECK(driven.marks().rectangle.empty());
    CHECK(driven.marks().selected == idsIn(driven, {-3, -3}, {0, 3}));
    CHECK(driven.marks().selected.size() == 8);
    driven.run(0.5);
    CHECK(driven.world.groupCount() == 1);  // To select changes nothing in the world.
}

TEST_CASE("Shift adds to a selection, Ctrl removes, a box alone replaces") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    box(driven, {-3, -3}, {-1, 3});
    CHECK(driven.marks().selected == idsIn(driven, {-3, -3}, {-1, 3}));
    box(driven, {0, -3}, {1, 3}, kShift);
    CHECK(driven.marks().selected.size() == 8);
    box(driven, {-3, -3}, {3, 0}, kControl);
    CHECK(driven.marks().selected.size() == 4);
    for (const std::uint32_t id : driven.marks().selected) CHECK(driven.positionOf(id).y > 0.0);
    box(driven, {1, -3}, {3, 3});
    CHECK(driven.marks().selected == idsIn(driven, {1, -3}, {3, 3}));
    box(driven, {6, 6}, {8, 8});
    CHECK(driven.marks().selected.empty());
    CHECK(driven.marks().notice == "Nobody is in the box");
}

TEST_CASE("A click takes one, two take the whole group, one on free ground takes nobody") {
    DrivenWorld driven(ninesApart(), "mouse-full-free");
    const Vec2 person = driven.positionOf(12);
    click(driven, person + Vec2{0.2, 0});
    CHECK(driven.marks().selected == Ids{12});
    driven.run(0.5);
    driven.tapTwice(person);
    CHECK(driven.marks().selected == driven.members(1));
    click(driven, {0, 0}, kShift);
    CHECK(driven.marks().selected.size() == 9);
    click(driven, driven.positionOf(1), kShift);
    CHECK(driven.marks().selected.size() == 10);
    click(driven, driven.positionOf(12), kControl);
    CHECK(driven.marks().selected.size() == 9);
    click(driven, {0, 0});
    CHECK(driven.marks().selected.empty());
}

TEST_CASE("Two clicks too far apart in time or place are no double click") {
    DrivenWorld driven(ninesApart(), "mouse-full-free");
    const Vec2 person = driven.positionOf(12);
    driven.tapTwice(person, person, 0.4);
    CHECK(driven.marks().selected == Ids{12});
    driven.run(0.5);
    driven.tapTwice(person + Vec2{-0.2, 0}, person + Vec2{0.2, 0});  // 4.5 mm.
    CHECK(driven.marks().selected == Ids{12});
    driven.run(0.5);
    driven.tapTwice(person, person + Vec2{0.2, 0});  // 2.2 mm.
    CHECK(driven.marks().selected.size() == 9);
}

TEST_CASE("The right button sends the selected, and the others get no order") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    box(driven, {-3, 0}, {3, 3});
    const Ids sent = driven.marks().selected;
    sendTo(driven, {2, 7});
    REQUIRE(driven.marks().goals.size() == 1);
    CHECK(distance(driven.marks().goals[0], {2, 7}) < 1e-6);
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(1) == sent);
    REQUIRE(driven.world.group(1).orders.size() == 1);
    CHECK(driven.world.group(1).orders[0].order.manner == Manner::Free);
    CHECK(driven.world.group(0).orders.empty());
    driven.run(8.0);
    CHECK(distance(driven.middleOf(sent), {2, 7}) < 0.5);
    CHECK(distance(driven.middle(0), {0, -1}) < 1.0);  // They close up round where they stood.
    CHECK(driven.world.group(1).orders.empty());
    CHECK(driven.refused.empty());
}

TEST_CASE("Shift queues a second point, to which the selected go after the first") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    box(driven, {-3, -3}, {3, 3});
    sendTo(driven, {7, 0});
    sendTo(driven, {7, 7}, kShift);
    REQUIRE(driven.world.groupCount() == 1);
    REQUIRE(driven.world.group(0).orders.size() == 2);
    CHECK(driven.world.group(0).orders[0].order.share == 0.6);
    CHECK(driven.marks().goals.size() == 2);
    double fromFirst = 1e9;
    for (int i = 0; i < 140; ++i) {
        driven.run(0.1);
        fromFirst = std::min(fromFirst, distance(driven.middle(), {7, 0}));
    }
    CHECK(fromFirst < 1.0);
    CHECK(distance(driven.middle(), {7, 7}) < 0.5);
    sendTo(driven, {0, 0});
    CHECK(driven.world.group(0).orders.size() == 1);
    CHECK(driven.marks().goals.size() == 1);
}

TEST_CASE("Points that come before the new group is made are queued, too") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    box(driven, {-3, 0}, {3, 3});
    const Ids sent = driven.marks().selected;
    driven.button = PointerButton::Right;
    for (const Vec2 ground : {Vec2{6, 2}, Vec2{6, 8}}) {
        driven.modifiers = ground.y > 5.0 ? kShift : Modifiers{};
        driven.down(1, ground);
        driven.up(1);
    }
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.world.group(1).orders.size() == 2);
    driven.run(14.0);
    CHECK(distance(driven.middleOf(sent), {6, 8}) < 0.5);
}

TEST_CASE("Those who are sent from two formations become one") {
    DrivenWorld driven(ninesApart(), "mouse-full-free");
    box(driven, {-4.5, -3}, {3.5, 3});  // Six of the left one, three of the right one.
    const Ids sent = driven.marks().selected;
    REQUIRE(sent.size() == 9);
    sendTo(driven, {0, 6});
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 3);
    CHECK(driven.members(2) == sent);
    press(driven, 'A', kControl);
    CHECK(driven.marks().selected.size() == 18);
    sendTo(driven, {0, -6});
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 1);
    driven.run(10.0);
    CHECK(distance(driven.middle(), {0, -6}) < 0.5);
    CHECK(driven.refused.empty());
}

TEST_CASE("Ctrl and a digit keep a selection, the digit brings it back") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    box(driven, {-3, -3}, {0, 3});
    const Ids left = driven.marks().selected;
    press(driven, '1', kControl);
    press(driven, kEscape);
    CHECK(driven.marks().selected.empty());
    box(driven, {0, 0}, {3, 3});
    const Ids corner = driven.marks().selected;
    REQUIRE(corner.size() == 4);
    press(driven, '2', kControl);
    press(driven, '1');
    CHECK(driven.marks().selected == left);
    press(driven, '2', kShift);
    CHECK(driven.marks().selected.size() == 12);
    press(driven, '2');
    CHECK(driven.marks().selected == corner);
    press(driven, '3');  // Nobody is kept there.
    CHECK(driven.marks().selected == corner);
}

TEST_CASE("S stops the selected where they are") {
    DrivenWorld driven(sixteen(), "mouse-full-free");
    press(driven, 'A', kControl);
    sendTo(driven, {9, 0});
    driven.run(1.5);
    CHECK(driven.middle().x > 0.5);
    press(driven, 'S');
    CHECK(driven.world.group(0).orders.empty());
    const Vec2 there = driven.middle();
    driven.run(4.0);
    CHECK(distance(driven.middle(), there) < 1.0);
}

TEST_CASE("Where nobody is selected the right button sends nobody and leaves a notice") {
    for (const char* scheme : {"mouse-full-free", "mouse-full-continuum"}) {
        DrivenWorld driven(sixteen(), scheme);
        sendTo(driven, {6, 0});
        CHECK(driven.marks().notice.find("Nobody is selected") != std::string::npos);
        driven.run(1.0);
        CHECK(driven.world.group(0).orders.empty());
    }
}

TEST_CASE("mouse-full-continuum sends by the continuum") {
    DrivenWorld driven(sixteen(), "mouse-full-continuum");
    press(driven, 'A', kControl);
    sendTo(driven, {7, 0});
    REQUIRE(driven.world.group(0).orders.size() == 1);
    CHECK(driven.world.group(0).orders[0].order.manner == Manner::Continuum);
    driven.run(8.0);
    CHECK(distance(driven.middle(), {7, 0}) < 1.6);  // They stand where there is room.
}

TEST_CASE("The paper's mouse selects by a right drag, sends by a left click, and knows no keys") {
    DrivenWorld driven(sixteen(), "mouse-paper");
    box(driven, {-3, -3}, {3, 3});  // A left drag selects nobody.
    CHECK(driven.marks().selected.empty());
    driven.button = PointerButton::Right;
    box(driven, {-3, 0}, {3, 3});
    const Ids upper = driven.marks().selected;
    REQUIRE(upper == idsIn(driven, {-3, 0}, {3, 3}));
    box(driven, {-3, -3}, {0, 0}, kShift);  // Shift does not add.
    CHECK(driven.marks().selected == idsIn(driven, {-3, -3}, {0, 0}));
    press(driven, 'A', kControl);
    CHECK(driven.marks().selected.size() == 4);
    box(driven, {-3, 0}, {3, 3});
    driven.button = PointerButton::Left;
    click(driven, {0, 7});
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(1) == upper);
    REQUIRE(driven.world.group(1).orders.size() == 1);
    CHECK(driven.world.group(1).orders[0].order.manner == Manner::Continuum);
    driven.run(8.0);
    CHECK(distance(driven.middleOf(upper), {0, 7}) < 1.0);
}
