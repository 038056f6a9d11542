// Undo of what fingers drag: the crowd is ordered to where it was to stand before, and walks there.
#include "engine/world/inspect.h"
#include "studio/gestures/input_event.h"
#include "studio/session/undo_desk.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Fingers on the first group, 16 in a square at the origin.
struct DragDesk : UndoDesk {
    double time = 1.0;

    void finger(TouchPhase phase, Vec2 at, std::uint32_t touch = 1) {
        client.touchAt(phase, at, time += 0.05, touch);
        settle(0.05);
    }
    void drag(Vec2 from, Vec2 to, double seconds = 5.0) {
        finger(TouchPhase::Down, from);
        for (int k = 1; k <= 5; ++k) finger(TouchPhase::Move, from + (to - from) * (0.2 * k));
        finger(TouchPhase::Up, to);
        settle(seconds);
    }
    Vec2 pose(std::size_t g = 0) const { return group(g).pose.position; }
    /// The middle of the people of the first group.
    Vec2 people() const {
        Vec2 sum;
        for (const std::int32_t member : group().members)
            sum += world().characters().position[static_cast<std::size_t>(member)];
        return sum / static_cast<double>(group().members.size());
    }
};

/// A screen from above, 20 pixels for a metre.
protocol::SetView screen() {
    const GroundView view = GroundView::fromAbove({}, 20.0, 960, 960, 0.28);
    protocol::SetView message;
    message.matrix.assign(view.toScreen.begin(), view.toScreen.end());
    message.width = view.width;
    message.height = view.height;
    message.mmPerPixel = view.mmPerPixel;
    return message;
}

/// Fingers that the session judges by a control scheme.
struct SchemeDesk : DragDesk {
    SchemeDesk() {
        client.send(screen());
        client.send(protocol::SetScheme{"touch"});
        settle();
    }
    void pointer(TouchPhase phase, Vec2 at, std::uint32_t number = 1) {
        protocol::RawInput input{.phase = phase,
                                 .device = protocol::PointerDevice::Touch,
                                 .button = protocol::PointerButton::Left,
                                 .pointer = number,
                                 .x = 480 + 20.0 * at.x,
                                 .y = 480 - 20.0 * at.y};
        input.time = time += 0.02;
        protocol::Inputs inputs{.events = {input}};
        client.send(inputs);
        settle(0.05);
    }
};

}  // namespace

TEST_CASE("a drag is one step, and the crowd walks back to where it was to stand") {
    DragDesk desk;
    desk.drag({0, 0}, {6, 2});
    CHECK(desk.history().undo == 1);
    CHECK(desk.history().undoLabel == "Drag");
    const Vec2 dragged = desk.pose();
    CHECK(distance(dragged, Vec2{6, 2}) < 0.5);
    CHECK(desk.people().x > 3.0);
    const Vec2 stood = desk.people();
    desk.undo();
    CHECK(distance(desk.pose(), Vec2{}) < 1e-6);
    CHECK(distance(desk.people(), stood) < 1.5);  // Nobody jumps.
    CHECK(desk.history().undo == 0);
    CHECK(desk.history().redoLabel == "Drag");
    desk.settle(6.0);
    CHECK(length(desk.people()) < 0.3);
    desk.undo(true);
    CHECK(distance(desk.pose(), dragged) < 1e-6);
    desk.settle(6.0);
    CHECK(distance(desk.people(), dragged) < 0.3);
    CHECK(desk.trouble().empty());
    desk.replays();
}

TEST_CASE("all fingers of a gesture are one step, which the last that lifts ends") {
    DragDesk desk;
    desk.finger(TouchPhase::Down, {-1.4, -1.4}, 1);
    desk.finger(TouchPhase::Down, {-1.4, 1.4}, 2);
    for (int k = 1; k <= 4; ++k) {
        desk.finger(TouchPhase::Move, {-1.4 + k, -1.4}, 1);
        desk.finger(TouchPhase::Move, {-1.4 + k, 1.4 + 0.2 * k}, 2);
    }
    desk.finger(TouchPhase::Up, {}, 1);
    CHECK(desk.history().undo == 0);
    desk.finger(TouchPhase::Up, {}, 2);
    CHECK(desk.history().undo == 1);
    desk.settle(4.0);
    CHECK(desk.pose().x > 2.0);
    desk.undo();
    CHECK(distance(desk.pose(), Vec2{}) < 1e-6);
    CHECK(desk.history().undo == 0);
}

TEST_CASE("a control that is made at once is dragged like fingers") {
    DragDesk desk;
    desk.client.send(commandsOf(AddControl{GroupId{1}, ControlKind::Point, {7}, {{0, 0}}, desk.time}));
    desk.settle(0.05);
    desk.finger(TouchPhase::Move, {0, -5}, 7);
    desk.finger(TouchPhase::Up, {0, -5}, 7);
    desk.settle(4.0);
    CHECK(desk.pose().y < -4.0);
    CHECK(desk.history().undoLabel == "Drag");
    desk.undo();
    CHECK(distance(desk.pose(), Vec2{}) < 1e-6);
}

TEST_CASE("a drag from the way of an order is not taken back while the order goes on") {
    DragDesk desk;
    desk.move(25, 0);
    desk.settle(1.0);
    desk.drag(desk.pose(), desk.pose() + Vec2{0, 3}, 1.0);
    CHECK(desk.history().undo == 2);
    const Vec2 led = desk.pose();
    desk.undo();  // Nothing is left of the drag, and the order is taken back.
    CHECK(desk.group().orders.empty());
    CHECK(desk.history().undo == 0);
    CHECK(distance(desk.pose(), led) < 2.0);
    CHECK(desk.trouble().empty());
}

TEST_CASE("the end of a pinned control leaves a drag that can be taken back") {
    DragDesk desk;
    desk.finger(TouchPhase::Down, {0, 0});
    desk.finger(TouchPhase::Move, {4, 0});
    desk.finger(TouchPhase::Move, {4, 0.1});
    REQUIRE(desk.group().controls.size() == 1);
    const std::uint32_t control = desk.group().controls[0].id.value;
    desk.client.send(commandsOf(EditControl{GroupId{1}, ControlId{control}, ControlEdit::Pin}));
    desk.finger(TouchPhase::Up, {4, 0});
    desk.settle(4.0);
    desk.client.send(commandsOf(EditControl{GroupId{1}, ControlId{control}, ControlEdit::Remove}));
    desk.settle(0.5);
    CHECK(desk.group().controls.empty());
    CHECK(desk.pose().x > 3.0);
    desk.undo();
    CHECK(distance(desk.pose(), Vec2{}) < 1e-6);
    CHECK(desk.trouble().empty());
}

TEST_CASE("a drag waits in a paused world and counts at once") {
    DragDesk desk;
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    desk.settle();
    desk.finger(TouchPhase::Down, {0, 0});
    desk.finger(TouchPhase::Move, {5, 0});
    CHECK(desk.history().undo == 0);
    desk.finger(TouchPhase::Up, {5, 0});
    CHECK(desk.history().undo == 1);
    CHECK(desk.history().undoLabel == "Drag");
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Play});
    desk.settle(4.0);
    CHECK(desk.pose().x > 3.0);
    desk.undo();
    CHECK(distance(desk.pose(), Vec2{}) < 1e-6);
}

TEST_CASE("fingers of another who holds the group keep it") {
    DragDesk desk;
    FakeClient other(desk.session, true, "other");
    desk.drag({0, 0}, {5, 0});
    const Vec2 dragged = desk.pose();
    other.touchAt(TouchPhase::Down, dragged, 9.0);
    desk.settle(0.1);
    REQUIRE(desk.group().controls.size() == 1);
    desk.undo();
    CHECK(distance(desk.pose(), dragged) < 0.2);
    CHECK(desk.group().controls.size() == 1);
}

TEST_CASE("a hand that stops a march and drags it takes both back at once") {
    SchemeDesk desk;
    desk.move(20, 0);
    desk.settle(1.0);
    const Vec2 from = desk.pose();
    REQUIRE(desk.targets() == std::vector{20.0});
    desk.pointer(TouchPhase::Down, from);
    for (int k = 1; k <= 6; ++k) desk.pointer(TouchPhase::Move, from + Vec2{0, 0.8 * k});
    desk.pointer(TouchPhase::Up, from + Vec2{0, 5});
    desk.settle(3.0);
    CHECK(desk.targets().empty());
    CHECK(desk.pose().y > 2.0);
    CHECK(desk.history().undo == 2);
    CHECK(desk.history().undoLabel == "Drag");
    desk.undo();
    CHECK(desk.targets() == std::vector{20.0});
    desk.undo();
    CHECK(desk.targets().empty());
    desk.undo(true);
    desk.undo(true);
    CHECK(desk.targets().empty());
    CHECK(desk.trouble().empty());
    desk.replays();
}

TEST_CASE("a formation that fingers spread is taken back with the drag") {
    SchemeDesk desk;
    const auto files = [&] { return inspect::ownFormation(desk.world(), 0).files; };
    REQUIRE(files() == 0);
    desk.pointer(TouchPhase::Down, {1.5, -1.5}, 1);
    desk.pointer(TouchPhase::Down, {1.5, 1.5}, 2);
    for (int k = 1; k <= 20; ++k) {
        desk.pointer(TouchPhase::Move, {1.5, -1.5 - 0.1 * k}, 1);
        desk.pointer(TouchPhase::Move, {1.5, 1.5 + 0.1 * k}, 2);
    }
    desk.pointer(TouchPhase::Up, {1.5, -3.5}, 1);
    desk.pointer(TouchPhase::Up, {1.5, 3.5}, 2);
    desk.settle(2.0);
    CHECK(files() > 4);
    CHECK(desk.history().undo == 1);
    CHECK(desk.history().undoLabel == "Drag");
    desk.undo();
    CHECK(files() == 0);
    CHECK(distance(desk.pose(), Vec2{}) < 1e-6);
    desk.undo(true);
    CHECK(files() > 4);
    CHECK(desk.trouble().empty());
}
