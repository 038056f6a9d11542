// A client without a browser: it exchanges bytes with a session and records what it receives.
#pragma once

#include <doctest.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/state/command_archive.h"
#include "muster/scenario.h"
#include "muster/session.h"
#include "studio/session/inbox/protocol.h"
#include "studio/session/page_decoder.h"

namespace muster::testing {

/// A floor of 24 m with 16 characters in the middle.
inline WorldDef smallFloor() {
    return {.name = "Small floor", .box = {{-12, -12}, {12, 12}}, .groups = {{.count = 16}}};
}

inline SessionDef sessionDef() {
    SessionDef def{.version = "test",
                   .scenarios = {{"small", "Small floor", "", 16}, {"broken", "Broken", "", 0}}};
    def.loadScenario = [](const std::string& name) -> Result<WorldDef> {
        if (name == "small") return smallFloor();
        return Status(StatusCode::ParseError, "broken.json: found nothing, expected a scenario");
    };
    return def;
}

/// The bytes of commands, as clients send them.
inline std::vector<std::uint8_t> commandBytes(std::span<const CommandBody> bodies) {
    Writer writer;
    for (const CommandBody& body : bodies) encodeBody(writer, body);
    return writer.take();
}

/// The bytes of one command.
inline std::vector<std::uint8_t> commandBytes(const CommandBody& body) {
    return commandBytes(std::span(&body, 1));
}
/// The same from the words of gesture files, which are easier to read in a test.
inline std::vector<std::uint8_t> commandBytes(const std::string& events) {
    const auto commands = parseCommands(events, "test", 1.0);
    REQUIRE_MESSAGE(commands.ok(), commands.status().message());
    std::vector<CommandBody> bodies;
    for (const Command& command : *commands) bodies.push_back(command.body);
    return commandBytes(bodies);
}

/// A message with one command.
inline protocol::Commands commandsOf(const CommandBody& body) {
    return {commandBytes(body)};
}
/// A message with the commands of a list of events.
inline protocol::Commands commandsOf(const std::string& events) {
    return {commandBytes(events)};
}
/// Another formation of the usual spacing.
inline protocol::Commands shaped(std::uint32_t group, FormationKind kind) {
    return commandsOf(ChangeGroup{.group = {group}, .formation = FormationDef{.kind = kind}});
}
/// An edit with the commands of a list of events.
inline protocol::Edit edited(const std::string& label, std::uint32_t gesture, const std::string& events) {
    return {label, gesture, commandBytes(events), {}};
}

/// One client of a session.
class FakeClient {
public:
    explicit FakeClient(Session& session, bool greet = true, const std::string& name = "fake")
        : session_(session), id(session.connect()) {
        if (greet) send(protocol::Hello{name});
    }

    template <class Message>
    void send(const Message& message) {
        sendBytes(protocol::encode(message));
    }
    void sendBytes(const std::vector<std::uint8_t>& bytes) { session_.receive(id, bytes); }

    /// Takes all waiting messages; acknowledges frames where `acknowledge` is set.
    void poll(bool acknowledge = true) {
        std::vector<MessageBytes> messages;
        session_.outgoing(id, messages);
        for (const MessageBytes& bytes : messages) {
            const auto message = protocol::decodeServer(bytes);
            REQUIRE_MESSAGE(message.ok(), message.status().message());
            take(message.value(), acknowledge);
        }
    }

    /// Makes one touch event.
    static protocol::TouchEvent touch(TouchPhase phase, Vec2 p, double time, std::uint32_t finger = 1) {
        return {phase, finger, p.x, p.y, time, 0};
    }
    void touchAt(TouchPhase phase, Vec2 p, double time, std::uint32_t finger = 1) {
        protocol::Touches touches;
        touches.events.push_back(touch(phase, p, time, finger));
        send(touches);
    }

    /// The text of the newest notice with that code; empty for none.
    std::string noticed(const std::string& code) const {
        for (auto i = notices.rbegin(); i != notices.rend(); ++i)
            if (i->code == code) return i->text;
        return {};
    }

private:
    void take(const protocol::ServerMessage& message, bool acknowledge) {
        if (const auto* m = std::get_if<protocol::Welcome>(&message)) welcome = *m;
        if (const auto* m = std::get_if<protocol::Scene>(&message)) scenes.push_back(*m);
        if (const auto* m = std::get_if<protocol::GroupMesh>(&message)) {
            meshes.push_back(*m);
            decoder_.take(*m);
        }
        if (const auto* m = std::get_if<protocol::Motions>(&message)) {
            if (motions.empty()) framesBeforeMotions = frames.size();
            motions.push_back(*m);
        }
        if (const auto* m = std::get_if<protocol::Overlay>(&message)) overlays.push_back(*m);
        if (const auto* m = std::get_if<protocol::Notice>(&message)) notices.push_back(*m);
        if (const auto* m = std::get_if<protocol::Forecasts>(&message)) forecasts.push_back(*m);
        if (const auto* m = std::get_if<protocol::Places>(&message)) places.push_back(*m);
        if (const auto* m = std::get_if<protocol::Standings>(&message)) standings.push_back(*m);
        if (const auto* m = std::get_if<protocol::Said>(&message)) said.push_back(*m);
        if (const auto* m = std::get_if<protocol::Marks>(&message)) marks.push_back(*m);
        if (const auto* m = std::get_if<protocol::Pong>(&message)) pongs.push_back(*m);
        if (const auto* m = std::get_if<protocol::Directors>(&message)) directors.push_back(*m);
        if (const auto* m = std::get_if<protocol::SharedWorld>(&message)) shared = *m;
        if (const auto* m = std::get_if<protocol::Ask>(&message)) asked.push_back(*m);
        if (const auto* m = std::get_if<protocol::AskAnswered>(&message)) answered.push_back(*m);
        if (const auto* m = std::get_if<protocol::PlaceKept>(&message)) placeKept = *m;
        if (const auto* m = std::get_if<protocol::Scenarios>(&message)) scenarios = *m;
        if (const auto* m = std::get_if<protocol::TakeState>(&message)) takes.push_back(*m);
        if (const auto* m = std::get_if<protocol::EditHistory>(&message)) history = *m;
        if (const auto* m = std::get_if<protocol::TakePath>(&message)) path = *m;
        if (const auto* m = std::get_if<protocol::TakeEdits>(&message)) takeEdits = *m;
        if (const auto* m = std::get_if<protocol::TakeReady>(&message)) ready = m->steps;
        if (const auto* m = std::get_if<protocol::TakeTracks>(&message)) tracks = *m;
        if (const auto* m = std::get_if<protocol::TakeKept>(&message)) kept.push_back(*m);
        if (const auto* m = std::get_if<protocol::StageTimes>(&message)) stageTimes.push_back(*m);
        if (const auto* m = std::get_if<protocol::Frame>(&message)) {
            frames.push_back(*m);
            page = decoder_.take(*m);
            if (acknowledge) send(protocol::FrameAck{m->frame});
        }
    }

    Session& session_;
    PageDecoder decoder_;

public:
    std::uint32_t id;
    std::optional<protocol::Welcome> welcome;
    std::vector<protocol::Scene> scenes;
    std::vector<protocol::GroupMesh> meshes;
    std::vector<protocol::Frame> frames;
    PageFrame page;  ///< The newest frame, decoded.
    std::vector<protocol::Motions> motions;
    std::size_t framesBeforeMotions = 0;
    std::vector<protocol::Overlay> overlays;
    std::vector<protocol::Notice> notices;
    std::vector<protocol::Forecasts> forecasts;
    std::vector<protocol::Places> places;
    std::vector<protocol::Standings> standings;
    std::vector<protocol::Said> said;
    std::vector<protocol::Marks> marks;
    std::vector<protocol::Pong> pongs;
    std::vector<protocol::Directors> directors;
    protocol::SharedWorld shared;  ///< The newest.
    std::vector<protocol::Ask> asked;
    std::vector<protocol::AskAnswered> answered;
    std::optional<protocol::PlaceKept> placeKept;
    std::optional<protocol::Scenarios> scenarios;
    std::vector<protocol::TakeState> takes;
    protocol::EditHistory history;  ///< The newest.
    std::optional<protocol::TakePath> path;
    std::optional<protocol::TakeTracks> tracks;
    std::optional<protocol::TakeEdits> takeEdits;
    std::uint32_t ready = 0;  ///< Steps of the last TakeReady.
    std::vector<protocol::TakeKept> kept;
    std::vector<protocol::StageTimes> stageTimes;
};

/// A session that has loaded the small floor.
inline Session startedSession(SessionDef def = sessionDef()) {
    Session session(std::move(def));
    const Status status = session.load("small", smallFloor());
    REQUIRE_MESSAGE(status.ok(), status.message());
    return session;
}

/// Lets `seconds` of real time pass in 60 updates per second.
inline void run(Session& session, double seconds, const std::vector<FakeClient*>& clients = {}) {
    const int looks = static_cast<int>(seconds * 60.0 + 0.5);
    for (int i = 0; i < looks; ++i) {
        session.elapse(1.0 / 60.0);
        while (session.stepDue()) session.step();
        for (FakeClient* client : clients) client->poll();
    }
}

}  // namespace muster::testing
