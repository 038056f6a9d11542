// Blocks of the open take: read, moved, copied, removed and stretched, and simulated again.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "studio/session/take_watcher.h"

using namespace muster;
using namespace muster::testing;
using protocol::TakeBlockKind;
using protocol::TrackEdit;

namespace {

/// Two groups far from each other, and a fountain.
WorldDef twoGroups() {
    WorldDef def{.name = "Two groups",
                 .box = {{-30, -20}, {30, 20}},
                 .groups = {{.name = "North", .count = 9, .position = {-20, 10}},
                            {.name = "South", .count = 9, .position = {-20, -10}}}};
    def.obstacles.push_back({.name = "Fountain", .centre = {0, 10}, .radius = 1.0});
    return def;
}

/// A recording of two groups, which directs them while it runs.
struct Recorded {
    Recorded() : session(sessionDef()), client(session) {
        REQUIRE(session.load("two", twoGroups()).ok());
        passes(0.5);
    }
    void give(const std::string& events) { client.send(commandsOf(events)); }
    void passes(double seconds) { run(session, seconds, {&client}); }
    std::vector<std::uint8_t> take() { return *session.take(); }

    Session session;
    FakeClient client;
};

/// North goes to the fountain, South becomes a ring and turns.
std::vector<std::uint8_t> directed() {
    Recorded recorded;
    recorded.give(R"([{"kind":"move","group":1,"x":-3,"y":10}])");
    recorded.passes(1.5);
    recorded.give(R"([{"kind":"changeGroup","group":2,"formation":"ring"}])");
    recorded.passes(14.0);
    return recorded.take();
}

/// One finger draws North to the right for two seconds.
std::vector<std::uint8_t> drawn() {
    Recorded recorded;
    for (int i = 0; i <= 120; ++i) {
        const Vec2 at{-20.0 + i / 40.0, 10.0};
        const TouchPhase phase = i == 0 ? TouchPhase::Down : i == 120 ? TouchPhase::Up : TouchPhase::Move;
        recorded.client.touchAt(phase, at, 10.0 + i / 60.0);
        recorded.passes(1.0 / 60.0);
    }
    recorded.passes(6.0);
    return recorded.take();
}

std::uint64_t lastHash(const Watcher& watcher) {
    const auto take = parseTake(*watcher.session.take(), "take");
    REQUIRE(take.ok());
    return take->marks.back().hash;
}

std::string refusal(const Watcher& watcher) {
    return watcher.client.noticed("EditTrack");
}

}  // namespace

TEST_CASE("tracks: a take is found as blocks of its groups, as people call them") {
    Watcher watcher(directed());
    const protocol::TakeTracks found = watcher.tracks();
    REQUIRE(found.tracks.size() == 2);
    CHECK(found.tracks[0].name == "North");
    CHECK(found.tracks[1].to == watcher.client.takes.back().steps);
    REQUIRE(found.blocks.size() == 2);
    const protocol::TakeBlock &move = found.blocks[0], &ring = found.blocks[1];
    CHECK(move.label == "Move to Fountain");
    CHECK(move.kind == TakeBlockKind::Order);
    CHECK(move.group == 1);
    CHECK(move.begin == 30);
    CHECK(move.end > 300);
    CHECK(move.end < watcher.client.takes.back().steps);
    CHECK(move.stretches);
    CHECK(ring.label == "Form a ring");
    CHECK(ring.group == 2);
    CHECK(ring.begin == 120);
    CHECK(found.undo.empty());
}

TEST_CASE("tracks: a moved order is carried out later, arrives later, and is taken back byte for byte") {
    Watcher watcher(directed());
    const auto before = *watcher.session.take();
    const std::uint64_t hash = lastHash(watcher);
    const protocol::TakeBlock was = watcher.tracks().blocks[0];
    const Vec2 at300 = watcher.path(1)[20];
    watcher.edit(TrackEdit::Move, 0, was.begin + 180);
    CHECK(watcher.client.notices.empty());
    const protocol::TakeTracks found = watcher.tracks();
    // The ring begins first now.
    REQUIRE(found.blocks.size() == 2);
    CHECK(found.blocks[0].label == "Form a ring");
    CHECK(found.blocks[1].begin == was.begin + 180);
    CHECK(found.blocks[1].end == was.end + 180);
    CHECK(watcher.path(1)[20].x < at300.x - 2.0);
    CHECK(found.undo == "Move “Move to Fountain”");
    CHECK(watcher.client.takes.back().title == "Two groups (changed)");
    const auto changed = *watcher.session.take();
    CHECK(changed != before);
    CHECK(replayTake(*parseTake(changed, "changed")).ok());

    watcher.edit(TrackEdit::Undo);
    CHECK(*watcher.session.take() == before);
    CHECK(watcher.tracks().redo == found.undo);
    watcher.edit(TrackEdit::Redo);
    CHECK(*watcher.session.take() == changed);
    REQUIRE(watcher.tracks().blocks.size() == 2);
    CHECK(watcher.tracks().blocks[1].end == found.blocks[1].end);
    // Back at its time, everything ends as it did.
    watcher.edit(TrackEdit::Move, 1, was.begin);
    CHECK(watcher.tracks().blocks[0].end == was.end);
    CHECK(lastHash(watcher) == hash);
    watcher.edit(TrackEdit::Undo);
    watcher.edit(TrackEdit::Undo);
    CHECK(*watcher.session.take() == before);
    watcher.edit(TrackEdit::Undo);
    CHECK(refusal(watcher).find("nothing to take back") != std::string::npos);
}

TEST_CASE("tracks: all changes of one take lie in one file beside it") {
    Watcher watcher(directed());
    watcher.edit(TrackEdit::Move, 0, 90);
    watcher.edit(TrackEdit::Move, 0, 100);
    REQUIRE(watcher.shelf.takes.size() == 1);
    CHECK(watcher.shelf.takes.begin()->second.bytes == *watcher.session.take());
    watcher.edit(TrackEdit::Undo);
    CHECK(watcher.shelf.takes.size() == 1);
    CHECK(watcher.shelf.takes.begin()->second.bytes == *watcher.session.take());
}

TEST_CASE("tracks: a copy is another order, also for another group; a removed one is not carried out") {
    Watcher watcher(directed());
    watcher.edit(TrackEdit::Copy, 0, 240, 2);
    CHECK(watcher.client.notices.empty());
    protocol::TakeTracks found = watcher.tracks();
    REQUIRE(found.blocks.size() == 3);
    CHECK(found.blocks[2].group == 2);
    CHECK(found.blocks[2].label == "Move to Fountain");
    CHECK(watcher.path(2).back().x > -10.0);
    watcher.edit(TrackEdit::Remove, 0);
    found = watcher.tracks();
    REQUIRE(found.blocks.size() == 2);
    CHECK(distance(watcher.path(1).back(), {-20, 10}) < 0.5);
    CHECK(watcher.path(2).back().x > -10.0);
}

TEST_CASE("tracks: a gesture is one block, which can be spread in time and moved") {
    Watcher watcher(drawn());
    protocol::TakeTracks found = watcher.tracks();
    REQUIRE(found.blocks.size() == 1);
    CHECK(found.blocks[0].kind == TakeBlockKind::Gesture);
    CHECK(found.blocks[0].label == "Touch");
    CHECK(found.blocks[0].group == 1);
    CHECK(found.blocks[0].end - found.blocks[0].begin == 120);
    const auto before = watcher.path(1);
    watcher.edit(TrackEdit::Stretch, 0, found.blocks[0].begin + 240);
    CHECK(watcher.client.notices.empty());
    found = watcher.tracks();
    REQUIRE(found.blocks.size() == 1);
    CHECK(found.blocks[0].end - found.blocks[0].begin == 240);
    const auto slow = watcher.path(1);
    CHECK(slow[10].x < before[10].x - 0.3);
    CHECK(distance(slow.back(), before.back()) < 0.5);
    watcher.edit(TrackEdit::Move, 0, found.blocks[0].begin + 60);
    CHECK(watcher.tracks().blocks[0].begin == found.blocks[0].begin + 60);
    CHECK(distance(watcher.path(1).back(), before.back()) < 0.5);
}

TEST_CASE("tracks: an order takes the time that it is given, by its pace") {
    Watcher watcher(directed());
    const protocol::TakeBlock was = watcher.tracks().blocks[0];
    watcher.edit(TrackEdit::Stretch, 0, was.begun + 2 * (was.end - was.begun));
    CHECK(watcher.client.notices.empty());
    const protocol::TakeBlock slow = watcher.tracks().blocks[0];
    const double share = static_cast<double>(slow.end - slow.begun) / (was.end - was.begun);
    CHECK(share > 1.7);
    CHECK(share < 2.3);
    watcher.edit(TrackEdit::Stretch, 1, 400);
    CHECK(refusal(watcher).find("“Form a ring” has no time of its own") != std::string::npos);
}

TEST_CASE("tracks: what later blocks need stays before them") {
    Recorded recorded;
    recorded.client.send(commandsOf(SplitGroup{.group = {1}, .by = SplitBy::Shares, .shares = {1, 1}}));
    recorded.passes(2.0);
    recorded.give(R"([{"kind":"move","group":3,"x":0,"y":0}])");
    recorded.passes(3.0);
    Watcher watcher(recorded.take());
    const auto before = *watcher.session.take();
    const protocol::TakeTracks found = watcher.tracks();
    REQUIRE(found.tracks.size() == 3);
    REQUIRE(found.blocks.size() == 2);
    CHECK(found.blocks[0].label == "Split");
    CHECK(found.blocks[1].group == 3);
    watcher.edit(TrackEdit::Move, 1, 10);
    CHECK(refusal(watcher).find("cannot begin before its group exists") != std::string::npos);
    watcher.edit(TrackEdit::Move, 0, 200);
    CHECK(refusal(watcher).find("have to stay in this order") != std::string::npos);
    watcher.edit(TrackEdit::Remove, 0);
    CHECK(refusal(watcher).find("“Split” at 0:00 makes what “Move” at 0:02 needs") != std::string::npos);
    watcher.edit(TrackEdit::Copy, 0, 20);
    CHECK(refusal(watcher).find("cannot begin before") != std::string::npos);
    watcher.edit(TrackEdit::Move, 7, 20);
    CHECK(refusal(watcher).find("found block 7") != std::string::npos);
    watcher.edit(TrackEdit::Move, 0, 99999);
    CHECK(refusal(watcher).find("after the end of the take") != std::string::npos);
    CHECK(*watcher.session.take() == before);
    // Times are those of the part that plays.
    watcher.client.send(protocol::EditTake{.from = 90, .to = 1000000});
    watcher.edit(TrackEdit::Remove, 0);
    CHECK_MESSAGE(refusal(watcher).find("at −0:01 makes what “Move” at 0:01 needs") != std::string::npos,
                  refusal(watcher));
    // Earlier it may be, and the one that nothing needs may go.
    watcher.edit(TrackEdit::Move, 0, 10);
    CHECK(refusal(watcher).empty());
    watcher.edit(TrackEdit::Remove, 1);
    CHECK(refusal(watcher).empty());
    watcher.edit(TrackEdit::Remove, 0);
    CHECK(refusal(watcher).empty());
    CHECK(watcher.tracks().tracks.size() == 2);
}

TEST_CASE("tracks: a stale block is left alone") {
    Watcher watcher(directed());
    const std::uint32_t old = watcher.tracks().revision;
    watcher.edit(TrackEdit::Move, 0, 60);
    watcher.change(protocol::EditTrack{old, TrackEdit::Remove, 0, 0, 0});
    CHECK(refusal(watcher).find("changed meanwhile") != std::string::npos);
    CHECK(watcher.tracks().blocks.size() == 2);
    Session still(sessionDef());
    REQUIRE(still.load("two", twoGroups()).ok());
    FakeClient client(still);
    client.send(protocol::EditTrack{1, TrackEdit::Remove, 0, 0, 0});
    client.poll();
    CHECK(client.noticed("EditTrack").find("no take is open") != std::string::npos);
}
