// Runs of the study as a server hosts them, without sockets.
#include "studio/study/host/study_host.h"

#include <cmath>

#include "studio/study/host/replay_host.h"
#include "studio/study/host/study_page.h"
#include "studio/study/trial/trial_replay.h"
#include "temporary_folder.h"

using namespace muster;
using muster::testing::StudyPage;
using protocol::StudyAct;
using protocol::StudyStage;

namespace {

using Page = StudyPage<StudyHost>;

/// A database of its own and a host on it.
struct Room {
    explicit Room(const std::string& name, RunKind kind = RunKind::Test) : folder("host_" + name) {
        auto opened = StudyStore::open(folder / "study.db", StoreMode::Create);
        REQUIRE_MESSAGE(opened.ok(), opened.status().message());
        store.emplace(std::move(opened).value());
        StudyHostDef def{.version = "1.0.0", .settings = {"mouse-paper", 16}, .kind = kind};
        def.now = [] { return std::string("2026-11-24T06:00:00Z"); };
        def.token = [this] { return "token-" + std::to_string(++tokens); };
        host.emplace(*store, std::move(def));
    }
    void run(double seconds, const std::vector<Page*>& pages) {
        for (int i = 0; i < static_cast<int>(seconds * 60.0 + 0.5); ++i) {
            host->elapse(1.0 / 60.0);
            while (host->stepDue()) host->step();
            for (Page* page : pages) page->poll();
        }
    }
    muster::testing::TemporaryFolder folder;
    int tokens = 0;
    std::optional<StudyStore> store;
    std::optional<StudyHost> host;
};

/// From consent to the first trial that waits.
void toReady(Page& page) {
    page.enter();
    while (page.stage() == StudyStage::Form) page.answer();
    REQUIRE(page.stage() == StudyStage::Ready);
}

protocol::SetView viewOfPage() {
    const GroundView view = studyView();
    protocol::SetView message;
    message.matrix.assign(view.toScreen.begin(), view.toScreen.end());
    message.width = view.width;
    message.height = view.height;
    message.mmPerPixel = 0.3;
    return message;
}

void point(Page& page, TouchPhase phase, Vec2 ground, double time) {
    const Vec2 at = studyView().screenOf(ground).value_or(Vec2{});
    protocol::RawInput input{.phase = phase, .pointer = 1, .x = at.x, .y = at.y, .time = time};
    page.send(protocol::Inputs{{input}});
}

/// Drags the crowd to the right with one finger.
void dragRight(Room& room, Page& page) {
    point(page, TouchPhase::Down, {-13.5, 0}, 0.0);
    room.run(0.2, {&page});
    for (int i = 1; i <= 20; ++i) {
        point(page, TouchPhase::Move, {-13.5 + 0.5 * i, 0}, 0.2 + 0.05 * i);
        room.run(0.05, {&page});
    }
    point(page, TouchPhase::Up, {-3.5, 0}, 1.3);
    room.run(3.0, {&page});
}

/// The trial of the database that is no practice and has the most inputs.
StudyTrial longest(StudyStore& store) {
    StudyTrial best;
    std::size_t most = 0;
    const std::vector<StudyTrial> trials = store.trials().value();
    for (const StudyTrial& trial : trials) {
        const std::size_t count = store.inputs(trial.id).value().size();
        if (count <= most) continue;
        most = count;
        best = trial;
    }
    return best;
}

TrialReplay replayOf(StudyStore& store, const StudyTrial& trial) {
    auto replay = TrialReplay::create(trial.def, store.inputs(trial.id).value(), trial.result.steps);
    REQUIRE_MESSAGE(replay.ok(), replay.status().message());
    return std::move(replay).value();
}

/// A stored trial in the studio, and who watches it.
struct Replay {
    ReplayHost host;
    StudyPage<ReplayHost> watcher;

    Replay(StudyStore& store, const StudyTrial& trial)
        : host(replayOf(store, trial), {"1.0.0", trial, RunKind::Test, {}}), watcher(host) {}
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * 60.0 + 0.5); ++i) {
            host.elapse(1.0 / 60.0);
            while (host.stepDue()) host.step();
            watcher.poll();
        }
    }
};

}  // namespace

TEST_CASE("A run begins with consent; a page that is only looked at leaves nothing behind") {
    Room room("consent");
    Page page(*room.host);
    page.enter();
    REQUIRE(page.form);
    CHECK(page.form->instrument == "consent");
    CHECK(page.states.back().test);
    CHECK(page.states.back().token.empty());
    CHECK(room.store->runs().value().empty());
    protocol::AnswerForm none{.instrument = "consent"};
    page.send(none);
    CHECK(page.noticed("AnswerForm").find("not answered") != std::string::npos);
    CHECK(room.store->runs().value().empty());
    page.act(StudyAct::Start);
    CHECK(page.noticed("DoInStudy").find("no run") != std::string::npos);
    page.answer();
    CHECK(room.store->runs().value().size() == 1);
    CHECK(page.states.back().token == "token-1");
    CHECK(page.form->instrument == "before");
}

TEST_CASE("A trial is played, given up and replays to the same hash") {
    Room room("replay");
    Page page(*room.host);
    toReady(page);
    CHECK(page.states.back().practice);
    CHECK(page.states.back().mmPerPixel == doctest::Approx(0.02));
    page.send(viewOfPage());
    page.act(StudyAct::Start);
    CHECK(page.stage() == StudyStage::Trial);
    dragRight(room, page);
    CHECK(page.scenes.size() == 1);
    REQUIRE(!page.frames.empty());
    CHECK(page.frames.back().time == doctest::Approx(4.3).epsilon(0.1));
    page.act(StudyAct::GiveUp);
    CHECK(page.noticed("DoInStudy").find("30 seconds") != std::string::npos);
    room.run(27.0, {&page});
    page.act(StudyAct::GiveUp);
    CHECK(page.stage() == StudyStage::Ready);
    CHECK(page.states.back().ended == protocol::TrialEnd::Practised);
    page.act(StudyAct::Start);
    dragRight(room, page);
    page.act(StudyAct::GiveUp);
    CHECK(page.states.back().ended == protocol::TrialEnd::GivenUp);
    const std::vector<StudyTrial> trials = room.store->trials().value();
    for (const StudyTrial& trial : trials) {
        TrialReplay replay = replayOf(*room.store, trial);
        while (!replay.atEnd()) REQUIRE(replay.step().ok());
        CHECK(replay.trial().world().hash() == trial.result.hash);
        CHECK(replay.trial().result().collected == trial.result.collected);
        CHECK(replay.trial().result().gestures == trial.result.gestures);
        CHECK(trial.result.gestures > 0);
    }
    CHECK(trials[1].state == RunState::BrokenOff);
}

TEST_CASE("A lost page pauses its trial, lifts its fingers, and comes back by its token") {
    Room room("lost");
    auto page = std::make_unique<Page>(*room.host);
    toReady(*page);
    page->send(viewOfPage());
    page->act(StudyAct::Start);
    point(*page, TouchPhase::Down, {-13.5, 0}, 0.0);
    room.run(1.0, {page.get()});
    const std::string token = page->states.back().token;
    const double time = page->frames.back().time;
    page->leave();
    room.run(5.0, {});
    Page back(*room.host);
    back.enter(token);
    CHECK(back.stage() == StudyStage::Paused);
    CHECK(back.states.back().run == page->states.back().run);
    room.run(2.0, {&back});
    REQUIRE(!back.frames.empty());
    CHECK(back.frames.back().time == doctest::Approx(time).epsilon(0.05));
    CHECK(!back.frames.back().playing);
    // What comes before the person goes on is no input.
    point(back, TouchPhase::Down, {-13.5, 0}, 0.0);
    back.act(StudyAct::GoOn);
    CHECK(back.stage() == StudyStage::Trial);
    room.run(31.0, {&back});
    back.act(StudyAct::GiveUp);
    const StudyTrial trial = longest(*room.store);
    const auto inputs = room.store->inputs(trial.id).value();
    const auto* last = std::get_if<PointerEvent>(&inputs.back().event);
    REQUIRE(last != nullptr);
    CHECK(last->phase == PointerPhase::Cancel);
    TrialReplay replay = replayOf(*room.store, trial);
    while (!replay.atEnd()) REQUIRE(replay.step().ok());
    CHECK(replay.trial().world().hash() == trial.result.hash);
}

TEST_CASE("Another window takes a run over, and the first one is told") {
    Room room("two-windows");
    Page page(*room.host);
    toReady(page);
    Page other(*room.host);
    other.enter(page.states.back().token);
    page.poll();
    CHECK(page.stage() == StudyStage::Elsewhere);
    CHECK(other.stage() == StudyStage::Ready);
    page.act(StudyAct::Start);
    CHECK(page.noticed("DoInStudy").find("no run") != std::string::npos);
    other.act(StudyAct::Start);
    CHECK(other.stage() == StudyStage::Trial);
    // The window that lost the run does not stop it by closing.
    page.leave();
    room.run(0.5, {&other});
    CHECK(other.frames.back().time > 0.3);
}

TEST_CASE("Two runs at once do not mix") {
    Room room("two-runs");
    Page first(*room.host);
    Page second(*room.host);
    toReady(first);
    toReady(second);
    CHECK(first.states.back().run != second.states.back().run);
    first.send(viewOfPage());
    second.send(viewOfPage());
    first.act(StudyAct::Start);
    second.act(StudyAct::Start);
    dragRight(room, first);
    room.run(30.0, {&first, &second});
    first.act(StudyAct::GiveUp);
    second.act(StudyAct::GiveUp);
    const auto trials = room.store->trials().value();
    REQUIRE(trials.size() == 2);
    CHECK(trials[0].result.gestures == 1);
    CHECK(trials[1].result.gestures == 0);
    CHECK(trials[0].result.hash != trials[1].result.hash);
    CHECK(trials[0].def.seed != trials[1].def.seed);
}

TEST_CASE("A run goes to thanks; one that is stopped, or whose server ends, is kept as broken off") {
    Room room("whole");
    Page page(*room.host);
    page.enter();
    for (int i = 0; i < 200 && page.stage() != StudyStage::Thanks; ++i) {
        if (page.stage() == StudyStage::Form) {
            page.answer();
        } else if (page.stage() == StudyStage::Ready) {
            page.act(StudyAct::Start);
            if (page.states.back().practice) room.run(30.5, {&page});
            page.act(StudyAct::GiveUp);
        }
    }
    CHECK(page.stage() == StudyStage::Thanks);
    Page stopped(*room.host);
    toReady(stopped);
    stopped.act(StudyAct::BreakOff);
    CHECK(stopped.stage() == StudyStage::BrokenOff);
    Page left(*room.host);
    toReady(left);
    left.act(StudyAct::Start);
    room.host->finish();
    const auto runs = room.store->runs().value();
    REQUIRE(runs.size() == 3);
    CHECK(runs[0].state == RunState::Complete);
    CHECK(runs[1].state == RunState::BrokenOff);
    CHECK(runs[2].state == RunState::BrokenOff);
    for (const StudyRun& run : runs) CHECK(run.kind == RunKind::Test);
    CHECK(room.store->trials(runs[0].id).value().size() == 10);
}

TEST_CASE("Messages that make no sense get one sentence") {
    Room room("hostile");
    Page page(*room.host);
    page.sendBytes({0xff, 1, 2});
    CHECK(!page.noticed("malformed").empty());
    page.send(protocol::LoadScenario{"open"});
    CHECK(page.noticed("LoadScenario").find("no such message") != std::string::npos);
    room.run(2.0, {&page});
    toReady(page);
    page.act(StudyAct::Start);
    protocol::RawInput input;
    page.send(protocol::Inputs{{input}});
    CHECK(page.noticed("Inputs").find("view") != std::string::npos);
    page.send(viewOfPage());
    input.time = std::nan("");
    page.send(protocol::Inputs{{input}});
    CHECK(page.noticed("Inputs").find("finite") != std::string::npos);
    room.run(2.0, {&page});
    input.time = 0.0;
    page.send(protocol::Inputs{std::vector<protocol::RawInput>(2000, input)});
    CHECK(page.noticed("Inputs").find("at most 1024") != std::string::npos);
    for (int i = 0; i < 3; ++i) page.send(protocol::Inputs{std::vector<protocol::RawInput>(1000, input)});
    CHECK(page.noticed("Inputs").find("2000 inputs a second") != std::string::npos);
    page.act(StudyAct::GoOn);
    CHECK(page.noticed("DoInStudy").find("paused") != std::string::npos);
    CHECK(page.stage() == StudyStage::Trial);
}

TEST_CASE("A replay in the studio shows the trial and its pointers, and ends with the stored hash") {
    Room room("watched");
    Page page(*room.host);
    toReady(page);
    page.send(viewOfPage());
    page.act(StudyAct::Start);
    dragRight(room, page);
    room.run(26.0, {&page});
    page.act(StudyAct::GiveUp);
    const StudyTrial trial = longest(*room.store);
    Replay replay(*room.store, trial);
    StudyPage<ReplayHost>& watcher = replay.watcher;
    CHECK(watcher.stage() == StudyStage::Replay);
    CHECK(watcher.states.back().scheme == trial.def.scheme);
    watcher.send(protocol::SetSpeed{8.0f});
    replay.run(5.0);
    CHECK(watcher.noticed("replay-end") == "The trial ends here; its hash is the stored one.");
    bool pointed = false;
    for (const protocol::Marks& marks : watcher.marks) pointed |= marks.pointers.size() == 2;
    CHECK(pointed);
    CHECK(!watcher.frames.back().playing);
    watcher.send(protocol::Playback{protocol::PlaybackAction::Play});
    replay.run(0.1);
    CHECK(watcher.frames.back().playing);
    CHECK(watcher.frames.back().time < 2.0);
    watcher.send(protocol::Playback{protocol::PlaybackAction::Pause});
    const double paused = watcher.frames.back().time;
    replay.run(1.0);
    CHECK(watcher.frames.back().time == doctest::Approx(paused).epsilon(0.2));
    watcher.send(protocol::SetSpeed{9.0f});
    CHECK(watcher.noticed("SetSpeed").find("0.1 to 8") != std::string::npos);
}

TEST_CASE("A replay tells of a hash that is not the stored one") {
    Room room("tampered");
    Page page(*room.host);
    toReady(page);
    page.send(viewOfPage());
    page.act(StudyAct::Start);
    room.run(31.0, {&page});
    page.act(StudyAct::GiveUp);
    StudyTrial trial = longest(*room.store);
    trial.result.hash ^= 1;
    Replay replay(*room.store, trial);
    replay.watcher.send(protocol::SetSpeed{8.0f});
    replay.run(7.0);
    CHECK(replay.watcher.noticed("replay-end").find("another hash") != std::string::npos);
    CHECK(replay.watcher.notices.back().level == protocol::NoticeLevel::Warning);
}
