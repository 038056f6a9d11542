// Takes in the studio: recorded parts, seeking, looping, speeds, and directing again.
#include <doctest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "base/random.h"
#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "studio/session/memory_shelf.h"
#include "studio/session/takes/take_moments.h"
#include "studio/session/takes/take_player.h"

using namespace muster;
using namespace muster::testing;

namespace {

using protocol::PlaybackAction;

WorldDef hundred() {
    WorldDef def{.name = "Hundred", .box = {{-30, -30}, {30, 30}}, .groups = {{.count = 100}}};
    def.obstacles.push_back({.polygon = {{6, -4}, {8, -4}, {8, 4}, {6, 4}}});
    return def;
}

/// Drags back and forth, and changes the formation, for so many seconds.
void direct(Session& session, FakeClient& client, double seconds) {
    const int pictures = static_cast<int>(seconds * 60.0);
    for (int i = 0; i < pictures; ++i) {
        const int part = i % 240;
        const double along = part < 120 ? part / 60.0 : (240 - part) / 60.0;
        const Vec2 at{6.0 * along - 3.0, 2.0 * along};
        const double time = 10.0 + i / 60.0;
        if (part == 0) client.touchAt(TouchPhase::Down, at, time);
        if (part > 0 && part < 180) client.touchAt(TouchPhase::Move, at, time);
        if (part == 180) client.touchAt(TouchPhase::Up, at, time);
        if (i % 600 == 300)
            client.send(shaped(1, i % 1200 == 300 ? FormationKind::Circle : FormationKind::Square));
        run(session, 1.0 / 60.0, {&client});
    }
}

/// A take of a directed world, from its first step.
std::vector<std::uint8_t> recorded(const WorldDef& def, double seconds) {
    Session session(sessionDef());
    REQUIRE(session.load("small", def).ok());
    FakeClient client(session);
    direct(session, client, seconds);
    auto bytes = session.take();
    REQUIRE(bytes.ok());
    return std::move(bytes).value();
}

/// Everything that is shown of a crowd.
struct Shown {
    std::uint64_t hash = 0;
    std::vector<float> places;
    std::vector<std::int16_t> poses;
    std::vector<std::uint8_t> clips;
    std::vector<double> phases;
    bool operator==(const Shown&) const = default;
};

Shown shown(const Session& session, const FakeClient& client) {
    const protocol::CrowdFrame& crowd = client.frames.back().crowd;
    CHECK(client.frames.back().step == session.world()->stepCount());
    return {session.world()->hash(), crowd.nearPlaces, crowd.nearPoses, client.page.clip, client.page.phase};
}

void seek(Session& session, FakeClient& client, std::uint32_t step) {
    client.send(protocol::Seek{step});
    while (session.stepDue() && session.world()->stepCount() != step) session.step();
    if (session.stepDue() && !session.playing()) session.step();
    client.poll();
}

void readWhole(Session& session) {
    while (session.preparing()) session.prepare();
}

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

TEST_CASE("A take begins where Record was pressed, and everybody learns when it is kept") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    Session session = startedSession(def);
    FakeClient client(session);
    run(session, 1.5, {&client});
    client.send(protocol::Record{true});
    CHECK(session.recordedTakeName() == "1.take");
    direct(session, client, 2.0);
    CHECK(client.frames.back().recordedSeconds == doctest::Approx(2.0).epsilon(0.01));
    client.send(protocol::Record{false});
    client.poll();
    REQUIRE(client.kept.size() == 1);
    CHECK(client.kept[0].name == "1.take");
    CHECK(client.kept[0].seconds == doctest::Approx(2.0).epsilon(0.01));
    CHECK(client.kept[0].scenario == "Small floor");
    const auto take = parseTake(shelf.takes.at("1.take").bytes, "1.take");
    REQUIRE(take.ok());
    CHECK(take->finished);
    CHECK(take->about.from == 90);
    CHECK(take->about.to == 210);
    CHECK(replayTake(*take).ok());  // The log since the world began.

    FakeClient viewer(session);
    REQUIRE(session.openTake(shelf.takes.at("1.take").bytes, "1.take", "1.take").ok());
    run(session, 0.1, {&viewer});
    CHECK(viewer.frames.front().step == 90);
    REQUIRE(viewer.takes.size() == 1);
    CHECK(viewer.takes[0].open);
    CHECK(viewer.takes[0].from == 90);
    CHECK(viewer.takes[0].to == 210);
    CHECK(viewer.takes[0].name == "1.take");
    CHECK(session.openTakeName() == "1.take");
    REQUIRE(!viewer.takes[0].marks.empty());
    CHECK(viewer.takes[0].marks[0].kind == protocol::TakeMarkKind::Touch);
    CHECK(viewer.takes[0].marks[0].step == 90);
    run(session, 5.0, {&viewer});
    CHECK(session.world()->stepCount() == 210);
    CHECK_FALSE(session.playing());
    // Once more from the beginning of the part.
    viewer.send(protocol::Playback{PlaybackAction::Play});
    run(session, 0.1, {&viewer});
    CHECK(session.world()->stepCount() >= 90);
    CHECK(session.world()->stepCount() < 100);
    viewer.send(protocol::LoadScenario{"small"});
    run(session, 0.1, {&viewer});
    CHECK_FALSE(viewer.takes.back().open);
}

TEST_CASE("A seek both ways in a minute of 100 characters shows the poses of straight play") {
    const auto bytes = recorded(hundred(), 60.0);
    Session session(sessionDef());
    REQUIRE(session.load("small", hundred()).ok());
    FakeClient client(session);
    protocol::Attend attend{.count = 100};
    client.send(attend);
    REQUIRE(session.openTake(bytes, "memory").ok());
    client.send(protocol::Playback{PlaybackAction::Pause});
    std::vector<std::uint32_t> moments = {1, 59, 60, 61, 600, 1234, 1799, 1800, 2437, 3005, 3599};
    std::map<std::uint32_t, Shown> straight;
    // Straight play, step by step, without any snapshot to go back to.
    while (session.world()->stepCount() < 3600) {
        client.send(protocol::Playback{PlaybackAction::SingleStep});
        session.step();
        const bool wanted = std::find(moments.begin(), moments.end(), session.world()->stepCount()) !=
                            moments.end();
        client.poll();
        if (wanted) straight[session.world()->stepCount()] = shown(session, client);
    }
    REQUIRE(straight.size() == moments.size());
    CHECK(straight[600].poses.size() == 100 * (3 + 3 * kJointCount));

    // Another session, which has not played it.
    Session other(sessionDef());
    REQUIRE(other.load("small", hundred()).ok());
    FakeClient viewer(other);
    viewer.send(attend);
    REQUIRE(other.openTake(bytes, "memory").ok());
    viewer.send(protocol::Playback{PlaybackAction::Pause});
    const double begun = secondsNow();
    readWhole(other);
    const double reading = secondsNow() - begun;
    other.elapse(0.3);
    viewer.poll();
    CHECK(viewer.ready == 3600);
    Random random(7);
    std::vector<double> times;
    for (int k = 0; k < 60; ++k) {
        const std::uint32_t step = moments[random.below(static_cast<std::uint32_t>(moments.size()))];
        const double before = secondsNow();
        seek(other, viewer, step);
        times.push_back(secondsNow() - before);
        REQUIRE(other.world()->stepCount() == step);
        CHECK(shown(other, viewer) == straight[step]);
    }
    std::sort(times.begin(), times.end());
    MESSAGE("measured: seek in 60 s of 100 characters p50 ", times[times.size() / 2] * 1e3, " ms, p95 ",
            times[times.size() * 95 / 100] * 1e3, " ms, worst ", times.back() * 1e3, " ms; read ahead in ",
            reading, " s");
    CHECK(times[times.size() / 2] < 0.1);
    // It plays on from there and matches every hash to the end.
    seek(other, viewer, 3000);
    viewer.send(protocol::Playback{PlaybackAction::Play});
    run(other, 11.0, {&viewer});
    CHECK(other.world()->stepCount() == 3600);
    CHECK(viewer.noticed("replay") == "");
    CHECK(viewer.noticed("replay-end").find("as it was recorded") != std::string::npos);
}

TEST_CASE("A seek beyond what has been read goes there in pieces, and the last one wanted counts") {
    const auto bytes = recorded(smallFloor(), 20.0);
    Session session = startedSession();
    FakeClient client(session);
    REQUIRE(session.openTake(bytes, "memory").ok());
    client.send(protocol::Playback{PlaybackAction::Pause});
    client.send(protocol::Seek{400});
    client.send(protocol::Seek{900});
    session.step();
    CHECK(session.world()->stepCount() == 90);
    CHECK(session.stepDue());
    client.send(protocol::Seek{30});
    while (session.stepDue()) session.step();
    CHECK(session.world()->stepCount() == 30);
    client.send(protocol::Seek{4'000'000'000});
    while (session.stepDue()) session.step();
    CHECK(session.world()->stepCount() == 1200);
    CHECK(client.noticed("replay") == "");
}

TEST_CASE("A part plays over and over, at its own speed") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    const auto bytes = recorded(smallFloor(), 6.0);
    Session session = startedSession(def);
    FakeClient client(session);
    REQUIRE(session.openTake(bytes, "memory", "a.take").ok());
    protocol::EditTake edit{.title = "A wave", .from = 60, .to = 120, .loop = true};
    client.send(edit);
    REQUIRE(shelf.edits.size() == 1);
    CHECK(shelf.edits[0].first == "a.take");
    CHECK(shelf.edits[0].second.from == 60);
    CHECK(client.noticed("EditTake") == "");
    std::set<std::uint32_t> steps;
    run(session, 1.5, {&client});
    for (int i = 0; i < 180; ++i) {
        run(session, 1.0 / 60.0, {&client});
        steps.insert(session.world()->stepCount());
    }
    CHECK(session.playing());
    CHECK(*steps.begin() >= 60);
    CHECK(*steps.rbegin() == 120);
    CHECK(steps.size() > 50);

    // Half as fast for all of it: 60 steps take two seconds.
    edit.loop = false;
    edit.speeds = {{0.0, 6.0, 0.5, 0.0}};
    client.send(edit);
    seek(session, client, 60);
    client.send(protocol::Playback{PlaybackAction::Play});
    run(session, 1.0, {&client});
    CHECK(session.world()->stepCount() == doctest::Approx(90).epsilon(0.03));
    run(session, 1.2, {&client});
    CHECK(session.world()->stepCount() == 120);
    CHECK_FALSE(session.playing());
    client.send(protocol::LoadScenario{"small"});
    client.send(edit);
    client.poll();
    CHECK(client.noticed("EditTake") == "no take is open");
}

TEST_CASE("What is wrong about a take is refused and named") {
    const auto bytes = recorded(smallFloor(), 2.0);
    Session session = startedSession();
    FakeClient client(session);
    for (const auto& message : {protocol::encode(protocol::Seek{3}), protocol::encode(protocol::TakeAgain{}),
                                protocol::encode(protocol::EditTake{})})
        client.sendBytes(message);
    client.poll();
    CHECK(client.noticed("Seek") == "no take is open");
    CHECK(client.noticed("TakeAgain").find("no take is open") != std::string::npos);
    REQUIRE(session.openTake(bytes, "memory").ok());
    const std::vector<std::pair<protocol::EditTake, std::string>> bad = {
        {{std::string(201, 'a'), 0, kTakeEnd, false, {}}, "title"},
        {{"a\nb", 0, kTakeEnd, false, {}}, "title"},
        {{"", 60, 60, false, {}}, "to: found 60"},
        {{"", 0, kTakeEnd, false, {{0, 1, 9.0, 0}}}, "speeds[0].speed"},
        {{"", 0, kTakeEnd, false, {{0, 1, 1.0, 0}, {0.5, 2, 1.0, 0}}}, "speeds[1].from"},
        {{"", 0, kTakeEnd, false, {{1, 1, 1.0, 0}}}, "speeds[0].to"},
        {{"", 0, kTakeEnd, false, {{0, 1, 1.0, -1}}}, "speeds[0].ease"},
    };
    for (const auto& [edit, words] : bad) {
        client.notices.clear();
        session.elapse(1.0);
        client.send(edit);
        client.poll();
        INFO(words);
        CHECK(client.noticed("EditTake").find(words) != std::string::npos);
    }
}

TEST_CASE("Directing again drops what was recorded later, and gives a take that replays") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    const auto bytes = recorded(smallFloor(), 8.0);
    const Take before = parseTake(bytes, "before").value();
    Session session = startedSession(def);
    FakeClient client(session);
    REQUIRE(session.openTake(bytes, "memory").ok());
    const std::uint32_t number = client.id;
    // A finger of the take is down at this moment.
    seek(session, client, 313);
    client.send(protocol::TakeAgain{false});
    client.poll();
    REQUIRE(client.welcome);
    CHECK(client.welcome->client > number);
    CHECK_FALSE(session.replaying());
    CHECK_FALSE(session.playing());
    run(session, 0.5, {&client});
    CHECK(session.world()->stepCount() == 313);  // It waits for a hand.
    client.touchAt(TouchPhase::Down, {0, 0}, 50.0, 9);
    run(session, 1.0, {&client});
    CHECK(session.playing());
    CHECK(session.world()->stepCount() > 360);
    for (const protocol::GroupFrame& group : client.frames.back().groups)
        for (const protocol::ControlFrame& control : group.controls)
            for (const protocol::ControlPointFrame& point : control.points)
                if (point.down) CHECK(control.client == client.welcome->client);
    client.touchAt(TouchPhase::Up, {1, 1}, 51.0, 9);
    run(session, 2.0, {&client});
    client.send(protocol::Record{false});
    client.poll();
    REQUIRE(client.kept.size() == 1);
    const auto again = parseTake(shelf.takes.at("1.take").bytes, "again");
    REQUIRE(again.ok());
    const auto report = replayTake(*again);
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->hash == session.world()->hash());
    CHECK(report->compared >= 7);
    for (const Command& command : again->commands)
        if (command.step >= 313 && command.step < 320 && command.client == number)
            CHECK(std::holds_alternative<ReleaseClient>(command.body));
    CHECK(again->marks[4] == before.marks[4]);
    CHECK(again->steps() == session.world()->stepCount());
}

TEST_CASE("Directing on top keeps what was recorded later") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    WorldDef floor = smallFloor();
    floor.groups.push_back(floor.groups[0]);
    floor.groups[1].position = {0, -8};
    const auto bytes = recorded(floor, 8.0);
    const Take before = parseTake(bytes, "before").value();

    // Without a hand on it, it goes as recorded.
    Session plain = startedSession(def);
    FakeClient quiet(plain);
    REQUIRE(plain.openTake(bytes, "memory").ok());
    seek(plain, quiet, 313);
    quiet.send(protocol::TakeAgain{true});
    quiet.send(protocol::Playback{PlaybackAction::Play});
    run(plain, (480 - 313) / 60.0, {&quiet});
    REQUIRE(plain.world()->stepCount() == 480);
    CHECK(plain.world()->hash() == before.marks.back().hash);

    Session session = startedSession(def);
    FakeClient client(session);
    REQUIRE(session.openTake(bytes, "memory").ok());
    seek(session, client, 20);
    client.send(protocol::TakeAgain{true});
    protocol::Touches down;
    down.events.push_back({TouchPhase::Down, 1, 0.0, -8.0, 30.0, 2});
    client.send(down);
    for (int i = 1; i < 120; ++i) {
        client.touchAt(TouchPhase::Move, {0.03 * i, -8.0}, 30.0 + i / 60.0);
        run(session, 1.0 / 60.0, {&client});
    }
    client.touchAt(TouchPhase::Up, {3, -8}, 32.0);
    run(session, 7.0, {&client});
    client.send(protocol::Record{false});
    const auto layered = parseTake(shelf.takes.rbegin()->second.bytes, "layered");
    REQUIRE(layered.ok());
    const auto report = replayTake(*layered);
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->hash == session.world()->hash());
    // All that was recorded is in it, and more.
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const Command& command : layered->commands) found.insert({command.client, command.sequence});
    for (const Command& command : before.commands) CHECK(found.contains({command.client, command.sequence}));
    CHECK(found.size() > before.commands.size());
    CHECK(session.world()->group(1).pose.position.x > 1.0);
}

TEST_CASE("A demonstration that is directed again from its middle replays") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    def.loadGestures = [](const std::string&, const WorldDef&) -> Result<std::vector<Command>> {
        std::vector<Command> commands;
        commands.push_back({10, 1, 1, Touch{TouchPhase::Down, 1, {0, 0}, 0.2, {}}});
        for (std::uint32_t k = 1; k < 200; ++k)
            commands.push_back(
                {10 + k, 1, 1 + k, Touch{TouchPhase::Move, 1, {0.03 * k, 0.0}, 0.2 + k / 60.0, {}}});
        return commands;
    };
    WorldDef floor = smallFloor();
    floor.gestures = "gestures.json";
    Session session(def);
    REQUIRE(session.load("small", floor).ok());
    FakeClient client(session);
    client.send(protocol::Playback{PlaybackAction::Demonstrate});
    run(session, 4.0, {&client});
    const auto bytes = session.take();
    REQUIRE(session.openTake(bytes.value(), "demonstration").ok());
    for (const bool keep : {false, true}) {
        REQUIRE(session.openTake(bytes.value(), "demonstration").ok());
        seek(session, client, 150);
        client.send(protocol::TakeAgain{keep});
        client.send(protocol::Playback{PlaybackAction::Play});
        run(session, 2.0, {&client});
        const auto take = parseTake(session.take().value(), "again");
        REQUIRE(take.ok());
        const auto report = replayTake(*take);
        REQUIRE_MESSAGE(report.ok(), report.status().message());
        CHECK(report->hash == session.world()->hash());
        const bool moved = std::any_of(take->commands.begin(), take->commands.end(), [](const Command& one) {
            return one.step > 150 && (touchOf(one.body, TouchPhase::Move) != nullptr);
        });
        CHECK(moved == keep);
    }
}

TEST_CASE("Recording goes on through Watch and Restart; a part in which nobody did anything is dropped") {
    MemoryShelf shelf;
    SessionDef def = sessionDef();
    shelf.serve(def);
    def.loadGestures = [](const std::string&, const WorldDef&) -> Result<std::vector<Command>> {
        return std::vector<Command>{{5, 1, 1, ChangeGroup{.group = GroupId{1}, .formation = FormationDef{}}}};
    };
    WorldDef floor = smallFloor();
    floor.gestures = "gestures.json";
    Session session(def);
    REQUIRE(session.load("small", floor).ok());
    FakeClient client(session);
    run(session, 0.5, {&client});
    client.send(protocol::Record{true});
    run(session, 0.5, {&client});
    client.send(protocol::Playback{PlaybackAction::Demonstrate});
    run(session, 1.0, {&client});
    CHECK(client.kept.empty());
    CHECK(shelf.takes.at("1.take").discarded);
    CHECK(client.frames.back().recordedSeconds == doctest::Approx(1.0).epsilon(0.03));
    client.send(protocol::Playback{PlaybackAction::Restart});
    run(session, 0.5, {&client});
    REQUIRE(client.kept.size() == 1);
    CHECK(client.kept[0].name == "2.take");
    CHECK(client.frames.back().recordedSeconds == doctest::Approx(0.5).epsilon(0.05));
    // Another scenario ends it, and it is kept even where nobody did anything.
    client.send(protocol::LoadScenario{"small"});
    run(session, 0.1, {&client});
    REQUIRE(client.kept.size() == 2);
    CHECK(client.kept[1].name == "3.take");
    CHECK(client.frames.back().recordedSeconds < 0.0f);
    for (const char* name : {"2.take", "3.take"}) {
        const auto take = parseTake(shelf.takes.at(name).bytes, name);
        REQUIRE(take.ok());
        CHECK(take->finished);
        CHECK(replayTake(*take).ok());
    }
}

TEST_CASE("Moments thin out where they take too much memory") {
    const ClipLibrary clips;
    CrowdMotion motion(clips);
    TakeMoments moments(60, 10'000);
    for (std::uint32_t step = 0; step <= 6000; step += 60)
        if (moments.missing(step))
            moments.keep(step, {std::vector<std::uint8_t>(1000, 0), motion.state(), {}});
    CHECK(moments.bytes() <= 10'000);
    CHECK(moments.count() >= 5);
    CHECK(moments.spacing() > 60);
    REQUIRE(moments.before(5999) != nullptr);
    CHECK(moments.before(5999)->first % moments.spacing() == 0);
    CHECK(5999 - moments.before(5999)->first < moments.spacing());
    CHECK(moments.before(0)->first == 0);
}
