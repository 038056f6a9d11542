#include <doctest.h>

#include <algorithm>
#include <memory>

#include "files/take/take_encoder.h"
#include "muster/take.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

struct KeptTake {
    std::vector<std::uint8_t> bytes;
    bool finished = false;
};

class MemorySink : public TakeSink {
public:
    explicit MemorySink(std::shared_ptr<KeptTake> kept) : kept_(std::move(kept)) {}
    Status append(std::span<const std::uint8_t> bytes) override {
        kept_->bytes.insert(kept_->bytes.end(), bytes.begin(), bytes.end());
        return {};
    }
    Status finish() override {
        kept_->finished = true;
        return {};
    }

private:
    std::shared_ptr<KeptTake> kept_;
};

// Steers for a while, partly between two steps and while paused.
void steer(Session& session, FakeClient& client) {
    client.touchAt(TouchPhase::Down, {0.2, 0.0}, 10.0);
    for (int i = 1; i <= 45; ++i) {
        client.touchAt(TouchPhase::Move, {0.2 + 0.06 * i, 0.02 * i}, 10.0 + i / 60.0);
        run(session, 1.0 / 60.0, {&client});
    }
    client.touchAt(TouchPhase::Up, {3, 1}, 10.8);
    client.send(shaped(1, FormationKind::Circle));
    run(session, 1.0, {&client});
    client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    client.touchAt(TouchPhase::Down, {3.0, 1.0}, 13.0, 2);
}

}  // namespace

TEST_CASE("The take of a session replays to the same hash") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.3, {&client});
    steer(session, client);
    const auto bytes = session.take();
    REQUIRE(bytes.ok());
    const auto take = parseTake(bytes.value(), "memory");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->finished);
    CHECK(take->steps() == session.world()->stepCount());
    const auto report = replayTake(take.value());
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->hash == session.world()->hash());
    CHECK(report->compared >= 2);
}

TEST_CASE("An opened take replays in the session, ends, and starts again") {
    Session first = startedSession();
    FakeClient director(first);
    steer(first, director);
    const auto bytes = first.take();
    REQUIRE(bytes.ok());

    Session second = startedSession();
    FakeClient viewer(second);
    REQUIRE(second.openTake(bytes.value(), "memory").ok());
    CHECK(second.replaying());
    run(second, 10.0, {&viewer});
    CHECK(second.world()->stepCount() == first.world()->stepCount());
    CHECK(second.world()->hash() == first.world()->hash());
    CHECK(viewer.frames.back().replaying);
    CHECK_FALSE(viewer.frames.back().playing);
    CHECK(viewer.noticed("replay-end") != "");
    CHECK(viewer.noticed("replay") == "");

    // Commands do not change a replay.
    viewer.touchAt(TouchPhase::Down, {0, 0}, 1.0);
    viewer.poll();
    CHECK(viewer.noticed("Touches").find("replayed") != std::string::npos);
    CHECK(second.take().value() == bytes.value());

    viewer.send(protocol::Playback{protocol::PlaybackAction::Play});
    REQUIRE(second.stepDue());
    second.step();
    CHECK(second.world()->stepCount() == 0);
    run(second, 10.0, {&viewer});
    CHECK(second.world()->hash() == first.world()->hash());

    viewer.send(protocol::LoadScenario{"small"});
    CHECK_FALSE(second.replaying());
    CHECK(second.playing());
}

TEST_CASE("A take that gives another state than recorded is reported at its mark") {
    Session first = startedSession();
    FakeClient director(first);
    run(first, 2.5, {&director});
    Take take = parseTake(first.take().value(), "memory").value();
    std::vector<std::uint8_t> forged = TakeEncoder::begin(take.def);
    for (HashMark mark : take.marks) {
        if (mark.step == 120) mark.hash ^= 1;
        const auto record = TakeEncoder::mark(mark);
        forged.insert(forged.end(), record.begin(), record.end());
    }
    Session second = startedSession();
    FakeClient viewer(second);
    REQUIRE(second.openTake(forged, "forged").ok());
    run(second, 5.0, {&viewer});
    CHECK(second.world()->stepCount() == 120);
    CHECK(viewer.noticed("replay").find("120") != std::string::npos);
}

TEST_CASE("Takes that cannot be opened change nothing") {
    SessionDef def = sessionDef();
    def.limits.openTakeBytes = 5000;
    Session session = startedSession(def);
    run(session, 0.5);
    const std::uint64_t hash = session.world()->hash();
    CHECK_FALSE(session.openTake({}, "empty").ok());
    const std::vector<std::uint8_t> noise(100, 7);
    CHECK_FALSE(session.openTake(noise, "noise").ok());
    const auto status = session.openTake(TakeEncoder::begin(smallFloor()), "stepless");
    CHECK_FALSE(status.ok());
    std::vector<std::uint8_t> large(5001, 0);
    CHECK(session.openTake(large, "large").code() == StatusCode::LimitExceeded);
    large.resize(5000);
    CHECK(session.openTake(large, "large").code() == StatusCode::ParseError);
    CHECK_FALSE(session.replaying());
    CHECK(session.world()->hash() == hash);
}

TEST_CASE("Recording keeps a whole take in a file, from the first step on") {
    auto kept = std::make_shared<KeptTake>();
    SessionDef def = sessionDef();
    def.openSink = [kept](const std::string& name) -> Result<std::unique_ptr<TakeSink>> {
        CHECK(name == "small");
        return std::unique_ptr<TakeSink>(new MemorySink(kept));
    };
    Session session = startedSession(def);
    FakeClient client(session);
    run(session, 0.5, {&client});
    CHECK(client.frames.back().recordedSeconds < 0.0f);
    client.send(protocol::Record{true});
    steer(session, client);
    client.send(protocol::Playback{protocol::PlaybackAction::Play});
    run(session, 0.25, {&client});
    CHECK(client.frames.back().recordedSeconds == doctest::Approx(2.0).epsilon(0.02));
    // If the process were killed now, the file would replay up to its last mark.
    const auto torn = parseTake(kept->bytes, "torn");
    REQUIRE(torn.ok());
    CHECK_FALSE(torn->finished);
    CHECK(torn->markedSteps() == 120);
    CHECK(torn->steps() > 120);  // A finger came down after the last mark.
    CHECK(replayTake(torn.value()).ok());
    // The studio replays it up to there, reports what was not compared, and returns it unchanged.
    Session other = startedSession();
    FakeClient viewer(other);
    REQUIRE(other.openTake(kept->bytes, "torn").ok());
    run(other, 5.0, {&viewer});
    CHECK(other.world()->stepCount() == torn->steps());
    const std::string rest = std::to_string(torn->steps() - 120);
    CHECK(viewer.noticed("replay-end").find("the last " + rest + " steps could not be checked") !=
          std::string::npos);
    CHECK(other.take().value() == kept->bytes);

    client.send(protocol::Record{false});
    CHECK(kept->finished);
    const auto whole = parseTake(kept->bytes, "whole");
    REQUIRE(whole.ok());
    CHECK(whole->finished);
    CHECK(whole->steps() == session.world()->stepCount());
    const auto report = replayTake(whole.value());
    REQUIRE(report.ok());
    CHECK(report->hash == session.world()->hash());
    const auto same = parseTake(session.take().value(), "memory");
    REQUIRE(same.ok());
    CHECK(same->commands.size() == whole->commands.size());
    CHECK(same->marks == whole->marks);
    CHECK(same->about == whole->about);
}

TEST_CASE("Restart, load and the end of the session finish the file") {
    for (int how = 0; how < 3; ++how) {
        auto kept = std::make_shared<KeptTake>();
        SessionDef def = sessionDef();
        def.openSink = [kept](const std::string&) -> Result<std::unique_ptr<TakeSink>> {
            return std::unique_ptr<TakeSink>(new MemorySink(kept));
        };
        Session session = startedSession(def);
        FakeClient client(session);
        client.send(protocol::Record{true});
        client.send(shaped(1, FormationKind::Circle));
        run(session, 0.5, {&client});
        if (how == 0) client.send(protocol::Playback{protocol::PlaybackAction::Restart});
        if (how == 1) client.send(protocol::LoadScenario{"small"});
        if (how == 2) session.finish();
        CHECK(kept->finished);
        if (how != 0) CHECK(parseTake(kept->bytes, "kept")->steps() == 30);
        client.poll();
        // A restart goes on recording; see takes_test.cpp.
        CHECK((client.frames.back().recordedSeconds < 0.0f) == (how != 0));
    }
}

TEST_CASE("A recording without a file gives a notice and goes on in memory") {
    SessionDef def = sessionDef();
    def.openSink = [](const std::string&) -> Result<std::unique_ptr<TakeSink>> {
        return Status(StatusCode::IoError, "takes: no room");
    };
    Session session = startedSession(def);
    FakeClient client(session);
    client.send(protocol::Record{true});
    run(session, 0.5, {&client});
    CHECK(client.noticed("record").find("no room") != std::string::npos);
    CHECK(client.frames.back().recordedSeconds > 0.4f);
    CHECK(parseTake(session.take().value(), "memory").ok());
}

TEST_CASE("A file that cannot be written is reported once, and the recording goes on in memory") {
    class FullSink : public TakeSink {
    public:
        Status append(std::span<const std::uint8_t>) override {
            return ++count_ < 5 ? Status() : Status(StatusCode::IoError, "takes/a.take: no room");
        }
        Status finish() override { return {}; }

    private:
        int count_ = 0;
    };
    SessionDef def = sessionDef();
    def.openSink = [](const std::string&) -> Result<std::unique_ptr<TakeSink>> {
        return std::unique_ptr<TakeSink>(new FullSink());
    };
    Session session = startedSession(def);
    FakeClient client(session);
    client.send(protocol::Record{true});
    const auto notices = [&] {
        return std::count_if(client.notices.begin(), client.notices.end(),
                             [](const protocol::Notice& notice) { return notice.code == "record"; });
    };
    run(session, 0.5, {&client});
    CHECK(notices() == 0);
    run(session, 5.0, {&client});
    CHECK(notices() == 1);
    CHECK(client.noticed("record").find("no room") != std::string::npos);
    CHECK(client.frames.back().recordedSeconds > 5.0f);
    client.send(protocol::Record{false});
    run(session, 0.1, {&client});
    CHECK(notices() == 1);
    CHECK(parseTake(session.take().value(), "memory")->finished);
}

TEST_CASE("A log that reaches its limit ends, gives one notice, and still replays") {
    SessionDef def = sessionDef();
    def.limits.takeBytes = TakeEncoder::begin(smallFloor()).size() + 2000;
    Session session = startedSession(def);
    FakeClient client(session);
    for (int i = 0; i < 300; ++i) {
        client.touchAt(i % 50 == 0 ? TouchPhase::Down : TouchPhase::Move, {0.01 * i, 0.0}, 1.0 + i / 60.0,
                       static_cast<std::uint32_t>(i / 50));
        run(session, 1.0 / 60.0, {&client});
    }
    CHECK(std::count_if(client.notices.begin(), client.notices.end(),
                        [](const protocol::Notice& notice) { return notice.code == "take-full"; }) == 1);
    const auto bytes = session.take();
    REQUIRE(bytes.ok());
    CHECK(bytes->size() <= def.limits.takeBytes);
    const auto take = parseTake(bytes.value(), "memory");
    REQUIRE(take.ok());
    CHECK(replayTake(take.value()).ok());
}
