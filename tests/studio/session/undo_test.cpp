// Undo of what directs groups: orders, shapes, conduct, splits and merges, in one history with edits of the
// place.
#include <doctest.h>

#include <string>
#include <vector>

#include "studio/session/undo_desk.h"

using namespace muster;
using namespace muster::testing;

namespace {

using Xs = std::vector<double>;

const std::string kAppend = R"(,"mode":"append")";

}  // namespace

TEST_CASE("the undo of a first order stops the group, and redo sends it on") {
    UndoDesk desk;
    desk.move(20, 0);
    CHECK(desk.history().undoLabel == "Move");
    desk.settle(1.0);
    desk.undo();
    CHECK(desk.group().orders.empty());
    CHECK(desk.history().undo == 0);
    CHECK(desk.history().redoLabel == "Move");
    desk.settle(3.0);
    const Vec2 stood = desk.group().pose.position;
    CHECK(stood.x < 10.0);
    desk.settle(1.0);
    CHECK(distance(desk.group().pose.position, stood) < 1e-9);
    desk.undo(true);
    CHECK(desk.targets() == Xs{20});
    desk.settle(1.0);
    CHECK(desk.group().pose.position.x > stood.x + 0.5);
    // The order has a new id, which the history knows.
    desk.undo();
    CHECK(desk.group().orders.empty());
    CHECK(desk.trouble().empty());
    desk.replays();
}

TEST_CASE("an order that is done is not given again, and its undo passes over it") {
    UndoDesk desk;
    desk.act(R"({"kind":"conduct","group":1,"cohesion":1})");
    desk.move(4, 0);
    desk.move(25, 0, kAppend);
    desk.settle(12.0);
    REQUIRE(desk.targets() == Xs{25});
    desk.undo();
    CHECK(desk.targets().empty());
    desk.undo();  // Of the first order nothing is left.
    CHECK(desk.history().undo == 0);
    CHECK(desk.history().redoLabel == "Cohesion");
    CHECK(desk.group().conduct.cohesion == 0.0);
    CHECK(desk.trouble().empty());
}

TEST_CASE("a shape is taken back, also one that an order gave") {
    UndoDesk desk;
    desk.act(R"({"kind":"formation","group":1,"formation":"ring"})");
    desk.client.send(shaped(1, FormationKind::Wedge));
    desk.settle();
    CHECK(desk.history().undoLabel == "Change shape");
    desk.undo();
    CHECK(desk.group().formation == FormationKind::Ring);
    desk.undo();
    CHECK(desk.group().formation == FormationKind::Square);
    desk.undo(true);
    CHECK(desk.group().formation == FormationKind::Ring);
    desk.act(R"({"kind":"guard","group":1,"x":2,"y":0,"halfSize":[3,3]})");
    CHECK(desk.group().formation == FormationKind::Points);
    CHECK(desk.history().undoLabel == "Guard");
    desk.undo();
    CHECK(desk.group().formation == FormationKind::Ring);
    CHECK(desk.group().orders.empty());
    CHECK(desk.trouble().empty());
    desk.replays();
}

TEST_CASE("a slider is one step, and each choice another") {
    UndoDesk desk;
    for (int k = 1; k <= 8; ++k)
        desk.act(R"({"kind":"conduct","group":1,"cohesion":0.)" + std::to_string(k) + "}");
    CHECK(desk.history().undo == 1);
    CHECK(desk.history().undoLabel == "Cohesion");
    desk.act(R"({"kind":"conduct","group":1,"cohesion":0.8,"stance":"hold"})");
    CHECK(desk.history().undo == 2);
    desk.settle(3.0);
    desk.act(R"({"kind":"conduct","group":1,"cohesion":0.5,"stance":"hold"})");
    CHECK(desk.history().undo == 3);
    desk.undo();
    CHECK(desk.group().conduct.cohesion == 0.8);
    desk.undo();
    CHECK(desk.group().conduct.stance == Stance::Normal);
    CHECK(desk.group().conduct.cohesion == 0.8);
    desk.undo();
    CHECK(desk.group().conduct.cohesion == 0.0);
    desk.undo(true);
    CHECK(desk.group().conduct.cohesion == 0.8);
}

TEST_CASE("parameters that are set at once are one step") {
    UndoDesk desk;
    const double reach = desk.world().parameters().input.reach;
    const double exponent = desk.world().parameters().plan.exponent;
    desk.client.send(commandsOf(SetParameter{"plan.exponent", 1.0}));
    desk.client.send(commandsOf(SetParameter{"input.reach", 2.5}));
    desk.settle();
    CHECK(desk.history().undo == 1);
    desk.undo();
    CHECK(desk.world().parameters().input.reach == reach);
    CHECK(desk.world().parameters().plan.exponent == exponent);
    desk.undo(true);
    CHECK(desk.world().parameters().input.reach == 2.5);
    CHECK(desk.world().parameters().plan.exponent == 1.0);
}

TEST_CASE("the undo of a merge brings the group back with all that it was") {
    UndoDesk desk;
    desk.move(20, 0);
    desk.act(R"({"kind":"move","group":2,"x":-20,"y":8},{"kind":"queue","group":2,"edit":"patrol"})");
    CHECK(desk.history().undoLabel == "Change orders");
    desk.act(R"({"kind":"merge","groups":[1,2]})");
    REQUIRE(desk.world().groupCount() == 1);
    CHECK(desk.history().undoLabel == "Merge");
    desk.settle(1.0);
    desk.undo();
    REQUIRE(desk.world().groupCount() == 2);
    CHECK(desk.group(0).count == 16);
    CHECK(desk.group(0).formation == FormationKind::Square);
    CHECK(desk.targets() == Xs{20});
    CHECK(desk.group(0).orders[0].order.target == Vec2{20, 0});
    const GroupView back = desk.group(1);
    CHECK(back.name == "Orange");
    CHECK(back.colour == 0x440E93u);
    CHECK(back.count == 9);
    CHECK(back.formation == FormationKind::Wedge);
    CHECK(back.conduct.cohesion == 0.25);
    CHECK(back.patrols);
    REQUIRE(back.orders.size() == 1);
    CHECK(back.orders[0].order.target == Vec2{-20, 8});
    // Its orders can be taken back although the group has another id.
    desk.undo();
    CHECK(desk.group(1).orders.empty());
    CHECK_FALSE(desk.group(1).patrols);
    for (int k = 0; k < 2; ++k) desk.undo(true);
    CHECK(desk.world().groupCount() == 1);
    desk.undo();
    CHECK(desk.world().groupCount() == 2);
    CHECK(desk.trouble().empty());
    desk.replays();
}

TEST_CASE("each director takes back their own acts") {
    UndoDesk desk;
    FakeClient other(desk.session, true, "other");
    desk.move(20, 0);
    other.send(commandsOf(R"([{"kind":"move","group":2,"x":-20,"y":0}])"));
    desk.settle();
    other.poll();
    CHECK(other.history.undo == 1);
    desk.undo();
    CHECK(desk.group(0).orders.empty());
    CHECK(desk.group(1).orders.size() == 1);
    desk.undo();
    CHECK(desk.client.noticed("UndoEdit") == "nothing to take back");
    CHECK(desk.group(1).orders.size() == 1);
    // What another director has ordered since stays.
    desk.move(15, 0);
    other.send(commandsOf(R"([{"kind":"move","group":1,"x":-15,"y":0}])"));
    desk.settle();
    desk.undo();
    CHECK(desk.targets() == Xs{-15});
    // The other one's undo does not bring back what was taken back meanwhile.
    other.send(protocol::UndoEdit{false});
    desk.settle();
    CHECK(desk.targets().empty());
}

TEST_CASE("a paused world tells what is taken back at once and makes no step for it") {
    UndoDesk desk;
    desk.move(20, 0);
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    desk.settle();
    const std::uint32_t steps = desk.world().stepCount();
    desk.move(5, 5, kAppend);
    desk.move(-5, 5, kAppend);
    CHECK(desk.history().undo == 3);
    desk.undo();
    desk.undo();
    desk.undo();
    CHECK(desk.history().undo == 0);
    CHECK(desk.history().redo == 3);
    desk.undo();
    CHECK(desk.client.noticed("UndoEdit") == "nothing to take back");
    desk.undo(true);
    CHECK(desk.history().undo == 1);
    CHECK(desk.world().stepCount() == steps);
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Play});
    desk.settle();
    CHECK(desk.targets() == Xs{20});
    CHECK(desk.history().undo == 1);
    CHECK(desk.history().redo == 2);
    desk.replays();
}

TEST_CASE("acts and edits of the place are one history") {
    UndoDesk desk;
    const std::string
        edit = R"([{"kind":"obstacle","definition":{"name":"Box","centre":[20,20],"radius":1}}])";
    desk.move(20, 0);
    desk.client.send(edited("Add disc", 0, edit));
    desk.settle();
    desk.act(R"({"kind":"formation","group":1,"formation":"ring"})");
    CHECK(desk.history().undo == 3);
    desk.undo();
    CHECK(desk.history().undoLabel == "Add disc");
    desk.undo();
    CHECK(desk.world().obstacleIds().empty());
    CHECK(desk.targets() == Xs{20});
    CHECK(desk.history().undoLabel == "Move");
    desk.undo(true);
    CHECK(desk.world().obstacleIds().size() == 1);
    // A new beginning undoes what was done to groups, and keeps the place.
    desk.client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    desk.settle();
    CHECK(desk.history().undo == 1);
    CHECK(desk.history().redo == 0);
    desk.undo();
    CHECK(desk.world().obstacleIds().empty());
}

TEST_CASE("a group that was added is taken back, and the place is not edited by acts") {
    UndoDesk desk;
    desk.act(R"({"kind":"group","definition":{"name":"Guests","count":5,"position":[-15,-15]}})");
    REQUIRE(desk.world().groupCount() == 3);
    CHECK(desk.history().undoLabel == "Add group");
    CHECK_FALSE(desk.history().edited);
    desk.undo();
    CHECK(desk.world().groupCount() == 2);
    desk.undo(true);
    REQUIRE(desk.world().groupCount() == 3);
    CHECK(desk.group(2).name == "Guests");
    desk.undo();
    CHECK(desk.world().groupCount() == 2);
}

TEST_CASE("what is refused, and what fingers do, is no step") {
    UndoDesk desk;
    desk.act(R"({"kind":"queue","group":1,"edit":"cancel","order":77})");
    desk.act(R"({"kind":"formation","group":9,"formation":"ring"})");
    desk.client.touchAt(TouchPhase::Down, {0, 0}, 1.0);
    desk.settle();
    desk.client.touchAt(TouchPhase::Up, {0, 0}, 1.2);
    desk.settle();
    CHECK(desk.history().undo == 0);
    desk.undo();
    CHECK(desk.client.noticed("UndoEdit") == "nothing to take back");
}

TEST_CASE("orders for several groups in one message are one step") {
    UndoDesk desk;
    desk.act(R"({"kind":"move","group":1,"x":20,"y":0},{"kind":"move","group":2,"x":-20,"y":0})");
    CHECK(desk.history().undo == 1);
    desk.undo();
    CHECK(desk.group(0).orders.empty());
    CHECK(desk.group(1).orders.empty());
    desk.undo(true);
    CHECK(desk.group(0).orders.size() == 1);
    CHECK(desk.group(1).orders.size() == 1);
}

TEST_CASE("a pin is taken back") {
    UndoDesk desk;
    desk.client.touchAt(TouchPhase::Down, {0, 0}, 1.0);
    desk.settle();
    REQUIRE(desk.group().controls.size() == 1);
    desk.client.send(
        commandsOf(EditControl{GroupId{1}, ControlId{desk.group().controls[0].id.value}, ControlEdit::Pin}));
    desk.settle();
    CHECK(desk.history().undoLabel == "Pin");
    CHECK(desk.group().controls[0].pinned);
    desk.undo();
    CHECK_FALSE(desk.group().controls[0].pinned);
    CHECK(desk.trouble().empty());
}

TEST_CASE("a history keeps a thousand steps") {
    UndoDesk desk;
    for (int k = 0; k < 1003; ++k)
        desk.client.send(commandsOf(R"([{"kind":"formation","group":1,"formation":")" +
                                    std::string(k % 2 == 0 ? "ring" : "square") + R"("}])"));
    desk.settle();
    CHECK(desk.history().undo == 1000);
    desk.undo();
    CHECK(desk.group().formation == FormationKind::Square);
}

TEST_CASE("what two directors did to the same things is taken back in any order") {
    for (const bool first : {true, false}) {
        UndoDesk desk;
        FakeClient other(desk.session, true, "other");
        const auto ask = [&](FakeClient& who, const std::string& event) {
            who.send(commandsOf("[" + event + "]"));
            desk.settle();
        };
        const double reach = desk.world().parameters().input.reach;
        desk.client.send(commandsOf(SetParameter{"input.reach", 2.0}));
        desk.settle();
        other.send(commandsOf(SetParameter{"input.reach", 3.0}));
        desk.settle();
        ask(desk.client, R"({"kind":"formation","group":1,"formation":"ring"})");
        ask(other, R"({"kind":"formation","group":1,"formation":"wedge"})");
        ask(desk.client, R"({"kind":"move","group":1,"x":20,"y":0})");
        ask(other, R"({"kind":"move","group":1,"x":15,"y":9,"mode":"append"})");
        ask(desk.client, R"({"kind":"bodies","ids":[3],"bodies":[{"mass":2}]})");
        ask(other, R"({"kind":"transfer","ids":[3],"group":2})");
        for (FakeClient* who : {first ? &desk.client : &other, first ? &other : &desk.client}) {
            for (int k = 0; k < 6; ++k) who->send(protocol::UndoEdit{false});
            desk.settle(0.5);
        }
        CHECK(desk.world().parameters().input.reach == reach);
        CHECK(desk.group().formation == FormationKind::Square);
        CHECK(desk.group().orders.empty());
        CHECK(desk.group().count == 16);
        CHECK(desk.world().characters().body[2] == Body{});
        CHECK(desk.client.noticed("rejected").empty());
        CHECK(desk.client.history.undo == 0);
    }
}

TEST_CASE("what another director has set since stays") {
    UndoDesk desk;
    FakeClient other(desk.session, true, "other");
    desk.act(R"({"kind":"formation","group":1,"formation":"ring"})");
    other.send(commandsOf(R"([{"kind":"formation","group":1,"formation":"wedge"}])"));
    desk.settle();
    desk.undo();
    CHECK(desk.group().formation == FormationKind::Wedge);
    other.send(protocol::UndoEdit{false});
    desk.settle();
    CHECK(desk.group().formation == FormationKind::Square);
}

TEST_CASE("a command that changes nothing is no step") {
    UndoDesk desk;
    desk.act(R"({"kind":"formation","group":1,"formation":"ring"})");
    desk.act(R"({"kind":"formation","group":1,"formation":"ring"})");
    desk.act(R"({"kind":"queue","group":1,"edit":"stop"})");
    CHECK(desk.history().undo == 1);
    desk.undo();
    CHECK(desk.group().formation == FormationKind::Square);
}

TEST_CASE("a group that comes back is named by sources and checkpoints as before") {
    UndoDesk desk;
    const auto edit = [&](const std::string& event) {
        desk.client.send(edited("Edit", 0, "[" + event + "]"));
        desk.settle();
    };
    edit(
        R"({"kind":"area","definition":{"kind":"source","polygon":[[20,20],[24,20],[24,24]],"rate":0},"group":2})");
    edit(
        R"({"kind":"checkpoint","definition":{"position":[25,-25],"radius":2,"formation":"ring"},"group":2})");
    desk.act(R"({"kind":"merge","groups":[1,2]})");
    desk.undo();
    REQUIRE(desk.world().groupCount() == 2);
    const GroupId merged = desk.group(1).id;
    CHECK(merged != GroupId{2});
    CHECK(desk.world().area(0).group == merged);
    CHECK(desk.world().checkpointGroups()[0] == merged);
    edit(R"({"kind":"removeGroup","group":)" + std::to_string(merged.value) + "}");
    desk.undo();
    const GroupId again = desk.group(1).id;
    CHECK(again != merged);
    CHECK(desk.world().area(0).group == again);
    CHECK(desk.group(1).name == "Orange");
    CHECK(desk.group(1).formation == FormationKind::Wedge);
    CHECK(desk.trouble().empty());
    desk.replays();
}

TEST_CASE("a group that was merged is to stand where it stood before") {
    UndoDesk desk;
    desk.act(R"({"kind":"merge","groups":[1,2]})");
    desk.settle(2.0);
    desk.undo();
    REQUIRE(desk.world().groupCount() == 2);
    CHECK(distance(desk.group(1).pose.position, Vec2{10, 8}) < 1e-6);
}

TEST_CASE("a queue that was reversed is taken back, and done again") {
    UndoDesk desk;
    desk.move(20, 0);
    desk.move(10, 5, kAppend);
    desk.move(5, 5, kAppend);
    desk.act(R"({"kind":"reverseQueue","group":1})");
    CHECK(desk.targets() == Xs{5, 10, 20});
    CHECK(desk.history().undoLabel == "Reverse orders");
    desk.undo();
    CHECK(desk.targets() == Xs{20, 10, 5});
    desk.undo(true);
    CHECK(desk.targets() == Xs{5, 10, 20});
    CHECK(desk.trouble().empty());
    desk.replays();
}
