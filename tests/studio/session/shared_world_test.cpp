// Directors on the one world that they share: who paused, builds or replaced it, asking first, and going
// back.
#include <doctest.h>

#include <string>

#include "studio/session/fake_client.h"
#include "studio/session/memory_shelf.h"
#include "studio/session/takes/take_titles.h"

using namespace muster;
using namespace muster::testing;
using protocol::PlaybackAction;
using protocol::WorldChange;

namespace {

struct TwoDirectors {
    explicit TwoDirectors(SessionDef def = sessionDef()) : session(startedSession(std::move(def))) {
        pass(0.2);
    }
    void pass(double seconds) { run(session, seconds, {&anna, &ben}); }
    std::uint64_t hash() const { return session.world()->hash(); }

    Session session;
    FakeClient anna{session, true, "Anna"};
    FakeClient ben{session, true, "Ben"};
};

}  // namespace

TEST_CASE("Who paused is shown until somebody plays") {
    TwoDirectors two;
    two.anna.send(protocol::Playback{PlaybackAction::Pause});
    two.pass(0.1);
    CHECK(two.ben.shared.pausedBy == two.anna.id);
    two.ben.send(protocol::Playback{PlaybackAction::Pause});  // It is paused already.
    two.pass(0.1);
    CHECK(two.anna.shared.pausedBy == two.anna.id);
    two.ben.send(protocol::Playback{PlaybackAction::Play});
    two.pass(0.1);
    CHECK(two.ben.shared.pausedBy == 0);
    CHECK(two.session.playing());
}

TEST_CASE("The world waits while somebody builds, and goes on afterwards where it went on before") {
    TwoDirectors two;
    two.anna.send(protocol::Build{true});
    two.ben.send(protocol::Build{true});
    two.pass(0.1);
    CHECK_FALSE(two.session.playing());
    CHECK(two.ben.shared.builders == std::vector<std::uint32_t>{two.anna.id, two.ben.id});
    CHECK(two.ben.shared.pausedBy == 0);
    two.anna.send(protocol::Build{false});
    two.pass(0.1);
    CHECK_FALSE(two.session.playing());  // The other builds.
    SUBCASE("the last one ends it") {
        two.ben.send(protocol::Build{false});
        two.pass(0.1);
        CHECK(two.session.playing());
        CHECK(two.anna.shared.builders.empty());
    }
    SUBCASE("the last one leaves") {
        two.session.disconnect(two.ben.id);
        CHECK(two.session.playing());
    }
    SUBCASE("what began again meanwhile waits, too") {
        two.anna.send(protocol::Playback{PlaybackAction::Restart});
        two.anna.send(protocol::Playback{PlaybackAction::Pause});
        two.pass(0.1);
        CHECK_FALSE(two.session.playing());
        two.ben.send(protocol::Build{false});
        two.pass(0.1);
        CHECK(two.session.playing());
    }
}

TEST_CASE("A world that was paused before somebody built stays paused") {
    TwoDirectors two;
    two.ben.send(protocol::Playback{PlaybackAction::Pause});
    two.anna.send(protocol::Build{true});
    two.anna.send(protocol::Build{false});
    two.pass(0.1);
    CHECK_FALSE(two.session.playing());
    CHECK(two.anna.shared.pausedBy == two.ben.id);
}

TEST_CASE("Everybody can go back to the world that somebody replaced, as it was") {
    TwoDirectors two;
    two.ben.send(edited("Add wall", 0, R"([{"kind":"obstacle","definition":{"centre":[9,9],"radius":1}}])"));
    two.ben.touchAt(TouchPhase::Down, {0, 0}, 0.3);
    two.pass(0.2);
    two.anna.send(protocol::LoadScenario{"small"});
    two.pass(0.5);
    CHECK(two.ben.shared.change == WorldChange::Opened);
    CHECK(two.ben.shared.changer == "Anna");
    CHECK(two.ben.shared.before == "Small floor");
    CHECK(two.ben.scenes.back().obstacles.empty());
    const std::uint32_t world = two.ben.scenes.back().world;
    two.ben.send(protocol::Playback{PlaybackAction::GoBack});
    two.pass(0.1);
    CHECK(two.ben.shared.change == WorldChange::WentBack);
    CHECK(two.ben.shared.changedBy == two.ben.id);
    CHECK(two.ben.scenes.back().world > world);
    CHECK(two.ben.scenes.back().obstacles.size() == 1);
    CHECK(two.session.world()->stepCount() > 20);
    CHECK(two.session.world()->group(0).controls.empty());  // Fingers have let go.
    // What was done there can still be taken back, and its take holds all of it.
    CHECK(two.ben.history.undo > 0);
    two.ben.touchAt(TouchPhase::Down, {0, 0}, 1.3);
    two.pass(0.3);
    CHECK(two.ben.noticed("rejected").empty());
    const auto bytes = two.session.take();
    REQUIRE(bytes.ok());
    const auto take = parseTake(*bytes, "take");
    REQUIRE(take.ok());
    const auto played = replayTake(*take);
    REQUIRE_MESSAGE(played.ok(), played.status().message());
    CHECK(played->hash == two.hash());
    // The one who went back can go forward again.
    two.anna.send(protocol::Playback{PlaybackAction::GoBack});
    two.pass(0.1);
    CHECK(two.ben.scenes.back().obstacles.empty());
}

TEST_CASE("What began again, and what is recorded, comes back") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    TwoDirectors two(std::move(def));
    two.anna.send(protocol::Record{true});
    two.anna.send(commandsOf(R"([{"kind":"move","group":1,"x":6,"y":4}])"));
    two.pass(1.0);
    const std::uint32_t steps = two.session.world()->stepCount();
    two.ben.send(protocol::LoadScenario{"small"});
    two.pass(0.2);
    CHECK(two.anna.frames.back().recordedSeconds < 0.0f);
    two.ben.send(protocol::Playback{PlaybackAction::GoBack});
    two.pass(0.2);
    CHECK(two.session.world()->stepCount() >= steps);
    CHECK(two.anna.frames.back().recordedSeconds > 1.0f);
    two.session.finish();
    REQUIRE(shelf.takes.size() == 2);
    const auto take = parseTake(shelf.takes["2.take"].bytes, "2.take");
    REQUIRE(take.ok());
    CHECK(replayTake(*take).ok());
    CHECK(take->steps() > steps);
}

TEST_CASE("A take that was open comes back at the same moment") {
    TwoDirectors two;
    two.pass(2.0);
    const auto bytes = two.session.take();
    REQUIRE(bytes.ok());
    REQUIRE(two.session.openTake(*bytes, "take", {}, two.anna.id).ok());
    CHECK(two.session.replaying());
    two.pass(0.5);
    const std::uint32_t step = two.session.world()->stepCount();
    two.ben.send(protocol::Playback{PlaybackAction::Pause});
    two.ben.send(protocol::LoadScenario{"small"});
    two.pass(0.2);
    CHECK_FALSE(two.session.replaying());
    two.anna.send(protocol::Playback{PlaybackAction::GoBack});
    two.pass(0.2);
    CHECK(two.session.replaying());
    CHECK_FALSE(two.session.playing());
    CHECK(two.session.world()->stepCount() == step);
}

TEST_CASE("Who leaves a take is back in the world that they left for it, as it was") {
    Session session = startedSession();
    FakeClient anna(session, true, "Anna");
    run(session, 0.5, {&anna});
    anna.send(edited("Add wall", 0, R"([{"kind":"obstacle","definition":{"centre":[9,9],"radius":1}}])"));
    run(session, 0.5, {&anna});
    const std::uint32_t step = session.world()->stepCount();
    const auto bytes = session.take();
    REQUIRE(bytes.ok());
    // Another take over the first one changes nothing of what waits beneath them.
    for (int i = 0; i < 2; ++i) {
        REQUIRE(session.openTake(*bytes, "take", {}, anna.id).ok());
        run(session, 0.2, {&anna});
        CHECK(anna.takes.back().beneath == "Small floor");
    }
    anna.send(protocol::Playback{PlaybackAction::LeaveTake});
    run(session, 0.2, {&anna});
    CHECK_FALSE(session.replaying());
    CHECK(session.world()->stepCount() >= step);
    CHECK(session.world()->stepCount() < step + 30);
    CHECK(anna.scenes.back().obstacles.size() == 1);
    CHECK(session.playing());
    anna.send(protocol::Playback{PlaybackAction::LeaveTake});
    run(session, 0.1, {&anna});
    CHECK(anna.noticed("Playback") == "there is no world to go back to");
}

TEST_CASE("What comes back while somebody builds goes on afterwards only where it ran") {
    TwoDirectors two;
    two.pass(1.0);
    const auto bytes = two.session.take();
    REQUIRE(bytes.ok());
    for (const bool taken : {true, false})
        for (const bool ran : {true, false}) {
            CAPTURE(taken);
            CAPTURE(ran);
            if (taken)
                REQUIRE(two.session.openTake(*bytes, "take", {}, two.anna.id).ok());
            else
                two.anna.send(protocol::LoadScenario{"small"});
            two.pass(0.3);
            two.ben.send(protocol::Playback{ran ? PlaybackAction::Play : PlaybackAction::Pause});
            two.ben.send(protocol::LoadScenario{"small"});
            two.ben.send(protocol::Build{true});
            two.anna.send(protocol::Playback{PlaybackAction::GoBack});
            two.pass(0.2);
            CHECK(two.session.replaying() == taken);
            CHECK_FALSE(two.session.playing());
            two.ben.send(protocol::Build{false});
            two.pass(0.1);
            CHECK(two.session.playing() == ran);
        }
}

TEST_CASE("Who is alone leaves nothing behind to go back to") {
    Session session = startedSession();
    FakeClient anna(session, true, "Anna");
    run(session, 0.1, {&anna});
    anna.send(protocol::LoadScenario{"small"});
    run(session, 0.1, {&anna});
    CHECK(anna.shared.before.empty());
    anna.send(protocol::Playback{PlaybackAction::GoBack});
    run(session, 0.1, {&anna});
    CHECK(anna.noticed("Playback") == "there is no world to go back to");
}

TEST_CASE("The others are asked, and who does not answer in time agrees") {
    TwoDirectors two;
    FakeClient cleo(two.session, true, "Cleo");
    const auto pass = [&](double seconds) { run(two.session, seconds, {&two.anna, &two.ben, &cleo}); };
    two.anna.send(protocol::AskOthers{" open\nOpen square "});
    pass(0.1);
    REQUIRE(two.ben.asked.size() == 1);
    const protocol::Ask asked = two.ben.asked.back();
    CHECK(asked.request == "openOpen square");
    CHECK(asked.client == two.anna.id);
    CHECK(two.anna.asked.empty());
    SUBCASE("all of them allow it") {
        two.ben.send(protocol::AnswerAsk{asked.number, true});
        pass(0.1);
        CHECK(two.anna.answered.empty());
        cleo.send(protocol::AnswerAsk{asked.number, true});
        pass(0.1);
        REQUIRE(two.anna.answered.size() == 1);
        CHECK(two.anna.answered.back().allowed);
        CHECK(cleo.asked.back().request.empty());
    }
    SUBCASE("one of them minds") {
        cleo.send(protocol::AnswerAsk{asked.number + 1, false});  // To another question.
        cleo.send(protocol::AnswerAsk{asked.number, false});
        pass(0.1);
        REQUIRE(two.anna.answered.size() == 1);
        CHECK_FALSE(two.anna.answered.back().allowed);
        CHECK(two.anna.answered.back().client == cleo.id);
        CHECK(two.ben.asked.back().request.empty());
    }
    SUBCASE("they are silent") {
        pass(14.0);
        CHECK(two.anna.answered.empty());
        pass(1.5);
        REQUIRE(two.anna.answered.size() == 1);
        CHECK(two.anna.answered.back().allowed);
    }
    SUBCASE("they leave") {
        two.ben.send(protocol::AnswerAsk{asked.number, true});
        two.session.disconnect(cleo.id);
        run(two.session, 0.1, {&two.anna, &two.ben});
        REQUIRE(two.anna.answered.size() == 1);
        CHECK(two.anna.answered.back().allowed);
    }
    SUBCASE("the asker gives it up") {
        two.anna.send(protocol::AskOthers{""});
        two.ben.send(protocol::AnswerAsk{asked.number, true});
        pass(16.0);
        CHECK(two.anna.answered.empty());
        CHECK(two.ben.asked.back().request.empty());
    }
    SUBCASE("another asks meanwhile") {
        two.ben.send(protocol::AskOthers{"begin again"});
        pass(0.1);
        REQUIRE(two.ben.answered.size() == 1);
        CHECK_FALSE(two.ben.answered.back().allowed);
        CHECK(two.ben.answered.back().client == two.anna.id);
    }
}

TEST_CASE("A place that is kept has its name from then on, and can be loaded by it") {
    SessionDef def = sessionDef();
    std::map<std::string, WorldDef> shelf;
    def.keepScenario = [&](const WorldDef& place) -> Result<ScenarioEntry> {
        shelf["places/yard"] = place;
        return ScenarioEntry{"places/yard", place.name, "", 16};
    };
    def.loadScenario = [&](const std::string& name) -> Result<WorldDef> { return shelf.at(name); };
    std::string shown;
    def.opened = [&](const std::string& name) { shown = name; };
    TwoDirectors two(std::move(def));
    two.ben.send(edited("Add wall", 0, R"([{"kind":"obstacle","definition":{"centre":[9,9],"radius":1}}])"));
    two.pass(0.2);
    two.ben.send(protocol::KeepPlace{"  "});
    two.pass(0.1);
    CHECK_FALSE(two.ben.placeKept->problem.empty());
    CHECK(shelf.empty());
    two.ben.send(protocol::KeepPlace{" My yard "});
    two.pass(0.1);
    CHECK(two.ben.placeKept->title == "My yard");
    CHECK(two.ben.placeKept->name == "places/yard");
    CHECK(two.anna.scenes.back().title == "My yard");
    CHECK(two.anna.scenes.back().name == "places/yard");
    CHECK(two.anna.scenarios->scenarios.back().title == "My yard");
    CHECK(shelf["places/yard"].obstacles.size() == 1);
    CHECK(shown == "places/yard");
    two.anna.send(protocol::LoadScenario{"places/yard"});
    two.pass(0.1);
    CHECK(two.anna.scenes.back().obstacles.size() == 1);
}

TEST_CASE("What is directed again has a title of its own") {
    CHECK(nextTitle("Through the door", {}) == "Through the door, 2");
    CHECK(nextTitle("Through the door, 2", {}) == "Through the door, 3");
    CHECK(nextTitle("Through the door", {"Through the door, 2", "Through the door, 3"}) ==
          "Through the door, 4");
    CHECK(nextTitle("Rome, Paris", {}) == "Rome, Paris, 2");
    CHECK(nextTitle(", 2", {}) == ", 2, 2");
}

TEST_CASE("The end of a take is said once") {
    TwoDirectors two;
    two.pass(1.0);
    const auto bytes = two.session.take();
    REQUIRE(bytes.ok());
    REQUIRE(two.session.openTake(*bytes, "take").ok());
    two.pass(2.0);
    CHECK_FALSE(two.anna.noticed("replay-end").empty());
    two.anna.notices.clear();
    two.anna.send(protocol::Playback{PlaybackAction::Play});
    two.pass(2.0);
    CHECK_FALSE(two.session.playing());
    CHECK(two.anna.noticed("replay-end").empty());
}
