// Messages that a hostile or broken client can send.
#include <doctest.h>

#include <limits>

#include "base/random.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

// One well-formed message of each kind.
std::vector<std::vector<std::uint8_t>> everyMessage() {
    protocol::Touches touches;
    touches.events.push_back(FakeClient::touch(TouchPhase::Down, {0, 0}, 1.0));
    touches.events.push_back(FakeClient::touch(TouchPhase::Move, {0.5, 0}, 1.1));
    const AddControl add{GroupId{1}, ControlKind::Line, {4, 5}, {{-1, 0}, {1, 0}}};
    return {protocol::encode(protocol::Hello{"again"}),
            protocol::encode(touches),
            protocol::encode(commandsOf(add)),
            protocol::encode(commandsOf(EditControl{GroupId{1}, ControlId{1}, ControlEdit::Pin})),
            protocol::encode(commandsOf(EditControl{GroupId{1}, ControlId{1}, ControlEdit::Remove})),
            protocol::encode(shaped(1, FormationKind::Wedge)),
            protocol::encode(commandsOf(ChangeGroup{.group = GroupId{1}, .count = 12})),
            protocol::encode(commandsOf(SetParameter{"plan.exponent", 1.5})),
            protocol::encode(protocol::Playback{protocol::PlaybackAction::SingleStep}),
            protocol::encode(protocol::SetSpeed{2.0f}),
            protocol::encode(protocol::LoadScenario{"small"}),
            protocol::encode(protocol::Record{true}),
            protocol::encode(protocol::SetOverlay{protocol::OverlayKind::Cost, 1}),
            protocol::encode(protocol::WatchStages{true}),
            protocol::encode(protocol::FrameAck{1}),
            protocol::encode(protocol::Ping{1.0})};
}

// Expects that a message is refused: a notice comes, and the world and its log do not change.
void checkRefused(Session& session, const std::vector<std::uint8_t>& bytes, const std::string& code) {
    FakeClient client(session);
    client.poll();
    const std::uint64_t hash = session.world()->hash();
    const auto take = session.take().value();
    client.sendBytes(bytes);
    client.poll();
    CHECK_MESSAGE(client.noticed(code) != "", code);
    CHECK(session.world()->hash() == hash);
    CHECK(session.take().value() == take);
    session.disconnect(client.id);
}

template <class Message>
void checkRefused(Session& session, const Message& message, const std::string& code) {
    checkRefused(session, protocol::encode(message), code);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("Messages that are too short or too long are malformed, whatever their kind") {
    Session session = startedSession();
    run(session, 0.2);
    for (const auto& whole : everyMessage()) {
        for (std::size_t length = 0; length<whole.size(); length += whole.size()> 40 ? 7 : 1)
            checkRefused(
                session,
                std::vector<std::uint8_t>(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)),
                "malformed");
        auto longer = whole;
        longer.push_back(0);
        checkRefused(session, longer, "malformed");
    }
}

TEST_CASE("Unknown numbers, flags and enumerations are malformed") {
    Session session = startedSession();
    checkRefused(session, std::vector<std::uint8_t>{15}, "malformed");
    checkRefused(session, std::vector<std::uint8_t>{255}, "malformed");
    auto transport = protocol::encode(protocol::Playback{protocol::PlaybackAction::Restart});
    transport[1] = 255;
    checkRefused(session, transport, "malformed");
    auto record = protocol::encode(protocol::Record{true});
    record[1] = 2;
    checkRefused(session, record, "malformed");
    // A list of four thousand million touches in nine bytes.
    checkRefused(session, std::vector<std::uint8_t>{1, 255, 255, 255, 255, 0, 0, 0, 0}, "malformed");
    checkRefused(session, std::vector<std::uint8_t>{0, 255, 255, 255, 255}, "malformed");
}

TEST_CASE("Random bytes never break a session") {
    Session session = startedSession();
    FakeClient client(session);
    FakeClient watcher(session);
    const auto messages = everyMessage();
    Random random(5);
    for (int i = 0; i < 4000; ++i) {
        std::vector<std::uint8_t> bytes;
        if (i % 2 == 0) {
            bytes = messages[random.below(static_cast<std::uint32_t>(messages.size()))];
            const std::uint32_t changes = 1 + random.below(4);
            for (std::uint32_t k = 0; k < changes; ++k)
                bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::uint8_t>(
                    random.below(256));
        } else {
            bytes.resize(random.below(80));
            for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
            if (!bytes.empty()) bytes[0] = static_cast<std::uint8_t>(random.below(16));
        }
        client.sendBytes(bytes);
        if (i % 20 == 0) {
            run(session, 1.0 / 60.0, {&watcher});
            client.poll();
        }
    }
    for (std::size_t i = 0; i < session.world()->characters().size(); ++i)
        CHECK(isFinite(session.world()->characters().position[i]));
    // The session still serves an honest client.
    watcher.send(protocol::LoadScenario{"small"});
    run(session, 0.2, {&watcher});
    CHECK(watcher.frames.back().crowd.count == 16);
}

TEST_CASE("Numbers out of range are refused, and accepted at the limit") {
    Session session = startedSession();
    run(session, 0.1);

    for (const auto& bad :
         {FakeClient::touch(TouchPhase::Down, {kNan, 0}, 1),
          FakeClient::touch(TouchPhase::Down, {0, 0}, kNan),
          FakeClient::touch(TouchPhase::Move, {0, std::numeric_limits<double>::infinity()}, 1)}) {
        protocol::Touches touches;
        // The valid event of the same message must not apply either.
        touches.events = {FakeClient::touch(TouchPhase::Down, {0, 0}, 1.0), bad};
        checkRefused(session, touches, "Touches");
    }
    checkRefused(session, commandsOf(AddControl{GroupId{1}, ControlKind::Line, {1}, {{0, 0}, {1, 0}}}),
                 "Commands");
    checkRefused(session, commandsOf(AddControl{GroupId{1}, ControlKind::Point, {1}, {{0, 0}}, kNan}),
                 "Commands");
    checkRefused(session, shaped(1, static_cast<FormationKind>(99)), "Commands");
    checkRefused(session, commandsOf(ChangeGroup{.group = GroupId{1}, .count = 0}), "Commands");
    checkRefused(session, commandsOf(ChangeGroup{.group = GroupId{1}, .count = 20001}), "Commands");
    checkRefused(session, commandsOf(ChangeGroup{.group = GroupId{1}, .count = -1}), "Commands");
    checkRefused(session, commandsOf(SetParameter{"plan.exponent", kNan}), "Commands");
    checkRefused(session, commandsOf(SetParameter{"no.such", 1.0}), "Commands");
    checkRefused(session, protocol::SetSpeed{0.0999f}, "SetSpeed");
    checkRefused(session, protocol::SetSpeed{8.001f}, "SetSpeed");
    checkRefused(session, protocol::SetSpeed{static_cast<float>(kNan)}, "SetSpeed");
    checkRefused(session, protocol::LoadScenario{"../../etc/passwd"}, "LoadScenario");
    checkRefused(session, protocol::LoadScenario{"broken"}, "LoadScenario");
    checkRefused(session, protocol::SetOverlay{protocol::OverlayKind::Cost, 999}, "SetOverlay");
    checkRefused(session, protocol::FrameAck{5}, "FrameAck");
    checkRefused(session, protocol::Hello{"twice"}, "Hello");

    FakeClient client(session);
    for (const float factor : {0.1f, 8.0f}) client.send(protocol::SetSpeed{factor});
    client.send(protocol::SetSpeed{1.0f});
    client.send(commandsOf(ChangeGroup{.group = GroupId{1}, .count = 1}));
    client.poll();
    CHECK(client.notices.empty());
}

TEST_CASE("A client's first message must be a Hello") {
    Session session = startedSession();
    const std::uint64_t hash = session.world()->hash();
    FakeClient client(session, false);
    client.touchAt(TouchPhase::Down, {0, 0}, 1.0);
    client.poll();
    CHECK(client.noticed("Touches").find("Hello") != std::string::npos);
    CHECK(client.frames.empty());
    CHECK(session.world()->hash() == hash);
}

TEST_CASE("Events of one message: the limit is accepted, one more is refused") {
    SessionDef def = sessionDef();
    def.limits.touchesPerMessage = 10;
    Session session = startedSession(def);
    FakeClient client(session);
    protocol::Touches touches;
    for (std::uint32_t i = 0; i < 10; ++i)
        touches.events.push_back(FakeClient::touch(TouchPhase::Move, {0, 0}, 1.0, i));
    client.send(touches);
    client.poll();
    CHECK(client.notices.empty());
    touches.events.push_back(touches.events.back());
    client.send(touches);
    client.poll();
    CHECK(client.noticed("Touches") == "found 11 touch events, expected at most 10");
}

TEST_CASE(
    "Touch events: the limit a second and of commands that wait is accepted, one more is refused, and later "
    "again") {
    for (const bool paused : {false, true}) {
        SessionDef def = sessionDef();
        if (paused) def.limits.waitingCommands = 20;
        if (!paused) def.limits.touchesPerSecond = 20;
        Session session = startedSession(def);
        FakeClient client(session);
        if (paused) client.send(protocol::Playback{protocol::PlaybackAction::Pause});
        const auto refused = [&](std::uint32_t from, std::uint32_t to) {
            client.notices.clear();
            for (std::uint32_t i = from; i < to; ++i) client.touchAt(TouchPhase::Move, {0, 0}, 1.0, i);
            client.poll();
            return client.noticed("Touches");
        };
        CHECK(refused(0, 20).empty());
        CHECK(refused(20, 21).find(paused ? "20 commands wait" : "more than 20") != std::string::npos);
        if (paused) client.send(protocol::Playback{protocol::PlaybackAction::SingleStep});
        run(session, 1.0, {&client});
        CHECK(refused(0, 20).empty());
    }
}

TEST_CASE("A client that leaves while the command queue is full still lifts its fingers") {
    SessionDef def = sessionDef();
    def.limits.waitingCommands = 30;
    Session session = startedSession(def);
    FakeClient watcher(session);
    FakeClient client(session);
    run(session, 0.1, {&watcher});
    client.touchAt(TouchPhase::Down, {0.2, 0.0}, 1.0);
    run(session, 0.5, {&watcher, &client});
    REQUIRE(watcher.frames.back().groups[0].controls.size() == 1);
    REQUIRE(watcher.frames.back().groups[0].controls[0].points[0].down);
    watcher.send(protocol::Playback{protocol::PlaybackAction::Pause});
    for (std::uint32_t i = 0; i < 30; ++i) watcher.touchAt(TouchPhase::Move, {0, 0}, 1.0, i);
    session.disconnect(client.id);
    watcher.send(protocol::Playback{protocol::PlaybackAction::Play});
    run(session, 5.0, {&watcher});
    CHECK(watcher.frames.back().groups[0].controls.empty());
}

TEST_CASE("Points of one control: the limit is accepted, one more is refused") {
    SessionDef def = sessionDef();
    def.limits.pointsPerControl = 3;
    Session session = startedSession(def);
    AddControl add{GroupId{1}, ControlKind::Area, {1, 2, 3}, {{-1, -1}, {1, -1}, {0, 1}}};
    FakeClient client(session);
    client.send(commandsOf(add));
    run(session, 0.1, {&client});
    CHECK(client.notices.empty());
    CHECK(client.frames.back().groups[0].controls.size() == 1);
    add.touches.push_back(4);
    add.positions.push_back({1, 1});
    checkRefused(session, commandsOf(add), "Commands");
}

TEST_CASE("Notices to one client are bounded") {
    Session session = startedSession();
    FakeClient client(session);
    for (int i = 0; i < 1000; ++i) client.sendBytes({99});
    client.poll();
    CHECK(client.notices.size() == 5);
    run(session, 1.0, {&client});
    for (int i = 0; i < 1000; ++i) client.sendBytes({99});
    client.poll();
    CHECK(client.notices.size() == 10);
}
