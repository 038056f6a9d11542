// Edits of people in the open take: shown, undone, kept with the take.
#include <doctest.h>

#include <algorithm>
#include <limits>

#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "studio/session/memory_shelf.h"
#include "studio/session/takes/edit_history.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A studio in which a take of a walking group is open and read.
struct EditDesk {
    EditDesk() : session(served(shelf)), client(session) {
        Session recorder(sessionDef());
        const WorldDef def{
            .name = "Floor", .box = {{-20, -10}, {20, 10}}, .groups = {{.count = 9, .position = {-10, 0}}}};
        REQUIRE(recorder.load("floor", def).ok());
        FakeClient director(recorder);
        director.send(commandsOf(R"([{"kind":"move","group":1,"x":10,"y":0}])"));
        run(recorder, 8.0, {&director});
        open(*recorder.take());
    }
    static SessionDef served(MemoryShelf& shelf) {
        SessionDef def = sessionDef();
        shelf.serve(def);
        return def;
    }
    void open(const std::vector<std::uint8_t>& bytes) {
        REQUIRE(session.openTake(bytes, "take", "1.take").ok());
        read();
        client.send(protocol::Playback{protocol::PlaybackAction::Pause});
        seek(240);
    }
    void read() {
        run(session, 0.1, {&client});
        while (session.preparing()) session.prepare();
        session.prepare();
    }
    void seek(std::uint32_t step) {
        client.send(protocol::Seek{step});
        run(session, 0.3, {&client});
        REQUIRE(session.world()->stepCount() == step);
    }
    void edit(const protocol::PeopleEdit& edit, std::uint32_t gesture = 0) {
        client.send(protocol::EditPeople{edit, gesture, true, false});
        read();
        run(session, 0.3, {&client});
    }
    Vec2 shown(std::uint32_t id) {
        run(session, 0.2, {&client});
        const auto& ids = client.page.ids;
        const auto at = std::find(ids.begin(), ids.end(), id) - ids.begin();
        REQUIRE(at < std::ssize(ids));
        return {client.page.x[at], client.page.y[at]};
    }

    MemoryShelf shelf;
    Session session;
    FakeClient client;
};

}  // namespace

TEST_CASE("a pin moves one person and nobody else, can be undone, and is kept with the take") {
    EditDesk desk;
    const Vec2 first = desk.shown(1), second = desk.shown(2);
    const std::uint64_t hash = desk.session.world()->hash();
    protocol::PeopleEdit edit;
    edit.people = {1};
    edit.pins = {{4.0, 0.0, 2.0, 2.0}};
    desk.edit(edit);
    CHECK(desk.client.notices.empty());
    CHECK(distance(desk.shown(1), first + Vec2{0.0, 2.0}) < 0.01);
    CHECK(desk.shown(2) == second);
    CHECK(desk.session.world()->hash() == hash);
    REQUIRE(desk.shelf.edits.size() == 1);
    CHECK(desk.shelf.edits[0].second.edits.size() == 1);
    const auto bytes = *desk.session.take();
    CHECK(parseTake(bytes, "take")->about.edits.size() == 1);
    CHECK(desk.client.history.undoLabel == "path of person 1");

    desk.client.send(protocol::UndoEdit{false});
    CHECK(distance(desk.shown(1), first) < 1e-6);
    CHECK(desk.client.history.redoLabel == "path of person 1");
    desk.client.send(protocol::UndoEdit{true});
    CHECK(distance(desk.shown(1), first + Vec2{0.0, 2.0}) < 0.01);

    desk.open(bytes);
    CHECK(distance(desk.shown(1), first + Vec2{0.0, 2.0}) < 0.01);
    CHECK(desk.client.history.undo == 0);
}

TEST_CASE("an own clock is read in the background, and findings come with the edits") {
    EditDesk desk;
    const Vec2 first = desk.shown(1);
    protocol::PeopleEdit edit;
    edit.people = {1};
    edit.clock = {{0.0, 0.0}, {4.0, 2.5}};
    desk.edit(edit);
    CHECK(distance(desk.shown(1), first) > 0.5);
    desk.seek(150);
    desk.edit({{1}, {}, {}, {}, {}});
    const Vec2 then = desk.shown(1);
    desk.edit(edit);
    desk.seek(240);
    CHECK(distance(desk.shown(1), then) < 0.01);
    edit = {{1}, {{4.0, 0.0, 60.0, 1.0}}, {}, {}, {}};
    desk.edit(edit);
    REQUIRE(desk.client.takeEdits.has_value());
    CHECK(desk.client.takeEdits->checked);
    REQUIRE_FALSE(desk.client.takeEdits->findings.empty());
    CHECK(desk.client.takeEdits->findings[0].person == 1);
}

TEST_CASE("bad edits are refused by a sentence and change nothing") {
    EditDesk desk;
    const auto refused = [&](const protocol::PeopleEdit& edit) {
        desk.client.notices.clear();
        desk.edit(edit);
        CHECK(desk.shelf.edits.empty());
        return desk.client.noticed("EditPeople");
    };
    CHECK(refused({{}, {}, {}, {}, {}}).find("found nobody") != std::string::npos);
    CHECK(refused({{99}, {{1.0, 1.0, 0.0, 1.0}}, {}, {}, {}}).find("no person 99") != std::string::npos);
    CHECK(refused({{1}, {}, {}, {{"fly", 1.0, 2.0}}, {}}).find("no clip \"fly\"; there are") !=
          std::string::npos);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(refused({{1}, {{nan, 1.0, 0.0, 1.0}}, {}, {}, {}}).empty());
}

TEST_CASE("whoever gets an edit leaves the one before; changes of a gesture are one step") {
    const TakeEdit both{{1, 2}, {{1.0, {1.0, 0.0}, 2.0}}, {}, {}, {}};
    const TakeEdit one{{2}, {{2.0, {1.0, 0.0}, 2.0}}, {}, {}, {}};
    const auto edits = withEdit({both}, one);
    REQUIRE(edits.size() == 2);
    CHECK(edits[0].people == std::vector<std::uint32_t>{1});
    CHECK(edits[1] == one);
    CHECK(withEdit(edits, {{1, 2}, {}, {}, {}, {}}).empty());
    CHECK(whatChanges({both}, {{1, 2}, {}, {}, {}, {}}) == "changes of 2 people");
    EditHistoryList history;
    history.add({}, "path of person 1", 7);
    history.add({both}, "path of person 1", 7);
    std::vector<TakeEdit> now{one};
    CHECK(history.go(false, now));
    CHECK(now.empty());
    CHECK_FALSE(history.go(false, now));
    CHECK(history.go(true, now));
    CHECK(now == std::vector<TakeEdit>{one});
}
