// Demonstrations: watching the gestures that a scenario carries.
#include <doctest.h>

#include <string>
#include <vector>

#include "muster/scenario.h"
#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

namespace {

const std::string kScenario = sourceFolder() + "/scenarios/block.json";

WorldDef blockDef() {
    auto def = loadScenario(kScenario);
    REQUIRE(def.ok());
    return std::move(def).value();
}

Session startedBlock() {
    SessionDef def = sessionDef();
    def.loadGestures = [](const std::string&, const WorldDef& world) {
        return loadScenarioGestures(kScenario, world);
    };
    Session session(std::move(def));
    REQUIRE(session.load("block", blockDef()).ok());
    return session;
}

/// A world that gets all gestures before its first step, as `muster play` submits them.
World played(bool withGestures) {
    const WorldDef def = blockDef();
    auto world = World::create(def);
    REQUIRE(world.ok());
    if (!withGestures) return std::move(world).value();
    const auto commands = loadScenarioGestures(kScenario, def);
    REQUIRE(commands.ok());
    for (const Command& command : commands.value()) REQUIRE(world->submit(command).ok());
    return std::move(world).value();
}

void demonstrate(FakeClient& client) {
    client.send(protocol::Playback{protocol::PlaybackAction::Demonstrate});
}

std::size_t fingersOf(const protocol::Frame& frame, std::uint32_t lowest, std::uint32_t highest) {
    std::size_t count = 0;
    for (const protocol::GroupFrame& group : frame.groups) {
        for (const protocol::ControlFrame& control : group.controls) {
            for (const protocol::ControlPointFrame& point : control.points)
                count += point.down && control.client >= lowest && control.client <= highest ? 1u : 0u;
        }
    }
    return count;
}

}  // namespace

TEST_CASE(
    "A demonstration has the hashes of a run of its gestures, at every step, and its take replays to them") {
    Session session = startedBlock();
    FakeClient client(session);
    run(session, 0.5, {&client});
    demonstrate(client);
    CHECK(session.world()->stepCount() == 0);
    CHECK(session.demonstrating());
    World plain = played(true);
    bool fingers = false;
    for (int look = 0; look < 6; ++look) {
        run(session, 0.35, {&client});
        while (plain.stepCount() < session.world()->stepCount()) plain.step();
        REQUIRE(plain.stepCount() == session.world()->stepCount());
        CHECK(plain.hash() == session.world()->hash());
        CHECK(client.frames.back().demonstrating);
        fingers = fingers || fingersOf(client.frames.back(), 1, kLastDemonstrator) > 0;
    }
    CHECK(fingers);
    const auto take = parseTake(session.take().value(), "memory");
    REQUIRE(take.ok());
    const auto report = replayTake(take.value());
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->hash == plain.hash());
}

TEST_CASE("People touch while a demonstration runs, as fingers of their own; the take has both") {
    Session session = startedBlock();
    FakeClient client(session);
    CHECK(client.id > kLastDemonstrator);
    demonstrate(client);
    run(session, 1.0, {&client});
    // The demonstration uses the same finger number.
    client.touchAt(TouchPhase::Down, {-11, 0}, 1.0, 1);
    client.touchAt(TouchPhase::Move, {-11, 2}, 1.2, 1);
    run(session, 0.5, {&client});
    CHECK(fingersOf(client.frames.back(), client.id, client.id) == 1);
    CHECK(fingersOf(client.frames.back(), 1, kLastDemonstrator) >= 1);
    CHECK(client.noticed("rejected") == "");
    const auto report = replayTake(parseTake(session.take().value(), "memory").value());
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->hash == session.world()->hash());
    World plain = played(true);
    while (plain.stepCount() < session.world()->stepCount()) plain.step();
    CHECK(plain.hash() != session.world()->hash());
}

TEST_CASE("Pausing halts a demonstration; restarting it or its last touch ends it") {
    Session session = startedBlock();
    FakeClient client(session);
    demonstrate(client);
    client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    run(session, 1.0, {&client});
    CHECK(session.world()->stepCount() == 0);
    CHECK(client.frames.back().demonstrating);
    client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    CHECK_FALSE(session.demonstrating());
    run(session, 1.0, {&client});
    CHECK_FALSE(client.frames.back().demonstrating);
    World plain = played(false);
    while (plain.stepCount() < session.world()->stepCount()) plain.step();
    CHECK(plain.hash() == session.world()->hash());

    demonstrate(client);
    const auto commands = loadScenarioGestures(kScenario, blockDef());
    const std::uint32_t last = commands->back().step;
    while (session.world()->stepCount() <= last) {
        CHECK(session.demonstrating());
        run(session, 1.0 / 60.0);
    }
    CHECK_FALSE(session.demonstrating());
    CHECK(session.playing());
}

TEST_CASE("A scene reports whether it has a demonstration; a request without one changes nothing") {
    Session session = startedBlock();
    FakeClient client(session);
    client.poll();
    CHECK(client.scenes.back().demonstration);
    const auto bytes = session.take();

    client.send(protocol::LoadScenario{"small"});
    run(session, 0.5, {&client});
    CHECK_FALSE(client.scenes.back().demonstration);
    const std::uint64_t hash = session.world()->hash();
    demonstrate(client);
    run(session, 0.0, {&client});
    client.poll();
    CHECK(client.noticed("Playback").find("carries no touches") != std::string::npos);
    CHECK(session.world()->hash() == hash);

    demonstrate(client);
    Session replay = startedBlock();
    FakeClient viewer(replay);
    run(session, 0.2);
    REQUIRE(replay.openTake(session.take().value(), "memory").ok());
    demonstrate(viewer);
    viewer.poll();
    CHECK(replay.replaying());
    CHECK(viewer.noticed("Playback").find("replayed") != std::string::npos);
    CHECK_FALSE(viewer.scenes.back().demonstration);
}

TEST_CASE("Gestures that cannot be loaded give a notice, and the world goes on") {
    for (const bool missing : {true, false}) {
        SessionDef def = sessionDef();
        def.loadGestures = [missing](const std::string&, const WorldDef&) -> Result<std::vector<Command>> {
            if (missing) return Status(StatusCode::IoError, "touches.json: cannot be opened");
            return std::vector<Command>{{0, kLastDemonstrator + 1, 1, CommandBody{ReleaseClient{}}}};
        };
        Session session(std::move(def));
        WorldDef floor = smallFloor();
        floor.gestures = "touches.json";
        REQUIRE(session.load("small", floor).ok());
        FakeClient client(session);
        run(session, 0.5, {&client});
        const std::uint32_t steps = session.world()->stepCount();
        demonstrate(client);
        client.poll();
        CHECK(session.world()->stepCount() == steps);
        CHECK_FALSE(session.demonstrating());
        CHECK(client.noticed("Playback").find(missing ? "cannot be opened" : "found the client 1001") !=
              std::string::npos);
    }
}
