// A session's inbox: a message becomes commands or changes how the session runs.
#include <algorithm>
#include <cmath>

#include "engine/world/inspect.h"
#include "studio/session/frames/notices.h"
#include "studio/session/inbox/answers.h"
#include "studio/session/inbox/chosen_scheme.h"
#include "studio/session/inbox/received_commands.h"
#include "studio/session/session_state.h"

namespace muster {
namespace {

constexpr std::int32_t kMaxSingleSteps = 60;  // Largest number of single steps that may wait.

CommandBody touchCommand(const protocol::TouchEvent& event, double time) {
    const bool down = event.phase == TouchPhase::Down;
    const bool placed = down || event.phase == TouchPhase::Move;
    return Touch{event.phase, event.touch, placed ? Vec2{event.x, event.y} : Vec2{}, time,
                 down ? GroupId{event.group} : GroupId{}};
}

Status limitExceeded(const std::string& what, std::size_t found, std::size_t most) {
    return {StatusCode::LimitExceeded,
            "found " + std::to_string(found) + " " + what + ", expected at most " + std::to_string(most)};
}

// Handles one message.
class Handler {
public:
    Handler(Session::Impl& session, SessionClient& client) : session_(session), client_(client) {}

    Status operator()(const protocol::Hello& message) {
        if (client_.greeted) return invalidArgument("a second Hello");
        session_.greet(client_, message.name);
        return {};
    }

    Status operator()(const protocol::SetName& message) {
        session_.directors.rename(client_.number, message.name);
        return {};
    }

    Status operator()(const protocol::GiveGroup& message) {
        const GroupDef* group = message.group == 0 ? nullptr : groupDef(message.group);
        if (message.group != 0 && group == nullptr) return noGroup(message.group);
        const Status status = session_.directors.give(message.client, GroupId{message.group});
        if (!status.ok()) return status;
        SessionClient* const given = session_.clientOf(message.client);
        if (given == nullptr || given == &client_) return {};
        const std::string what = group == nullptr ? "everything" : group->name;
        session_.notice(*given, protocol::NoticeLevel::Info, "director",
                        session_.directors.name(client_.number) + " gave you " + what + " to direct.");
        return {};
    }

    Status operator()(const protocol::Touches& message) {
        const SessionLimits& limits = session_.def.limits;
        if (message.events.size() > limits.touchesPerMessage)
            return limitExceeded("touch events", message.events.size(), limits.touchesPerMessage);
        for (const protocol::TouchEvent& event : message.events) {
            if (!std::isfinite(event.time)) return invalidArgument("a touch with a time that is not finite");
        }
        if (!client_.touches.take(session_.realTime, static_cast<double>(message.events.size())))
            return tooManyTouches("touch events");
        TouchClock clock = client_.clock;  // Stored only if every event of the message is valid.
        std::vector<CommandBody> bodies;
        double newest = client_.touchWaiting;
        for (const protocol::TouchEvent& event : message.events) {
            bodies.push_back(touchCommand(event, stamp(clock, event.time)));
            newest = std::max(newest, event.time);
        }
        const Status status = submit(std::move(bodies));
        if (!status.ok()) return status;
        client_.clock = clock;
        client_.touchWaiting = newest;
        return status;
    }

    Status operator()(const protocol::Playback& message) {
        if (!session_.world) return noWorld();
        switch (message.action) {
            case protocol::PlaybackAction::Play:
                if (session_.player && session_.player->atEnd(*session_.world)) return session_.restart();
                session_.resume();
                break;
            case protocol::PlaybackAction::Pause:
                session_.pause(client_);
                break;
            case protocol::PlaybackAction::SingleStep:
                session_.pause(client_);
                session_.singleSteps = std::min(session_.singleSteps + 1, kMaxSingleSteps);
                break;
            case protocol::PlaybackAction::Restart:
                if (session_.player) return session_.restart();
                return session_.beginFor(client_.id, protocol::WorldChange::Restarted,
                                         [&] { return session_.restart(); });
            case protocol::PlaybackAction::Demonstrate:
                return session_.beginFor(client_.id, protocol::WorldChange::Watched,
                                         [&] { return session_.demonstrate(); });
            case protocol::PlaybackAction::GoBack:
                return session_.goBack(client_.id);
            case protocol::PlaybackAction::LeaveTake:
                return session_.leaveTake(client_.id);
        }
        session_.pacer.reset();
        session_.touchState();
        return {};
    }

    Status operator()(const protocol::SetSpeed& message) {
        if (!(message.factor >= 0.1f && message.factor <= 8.0f)) {
            return invalidArgument("found a speed of " + std::to_string(message.factor) +
                                   ", expected 0.1 to 8");
        }
        session_.speed = message.factor;
        session_.touchState();
        return {};
    }

    Status operator()(const protocol::LoadScenario& message) {
        const auto& all = session_.def.scenarios;
        const auto found = std::find_if(
            all.begin(), all.end(), [&](const ScenarioEntry& entry) { return entry.name == message.name; });
        if (found == all.end() || !session_.def.loadScenario)
            return {StatusCode::NotFound, "no scenario is called '" + message.name.substr(0, 60) + "'"};
        const auto def = session_.def.loadScenario(found->name);
        if (!def.ok()) return def.status();
        return session_.beginFor(client_.id, protocol::WorldChange::Opened,
                                 [&] { return session_.begin(found->name, def.value()); });
    }

    Status operator()(const protocol::Record& message) {
        if (!session_.world) return noWorld();
        if (session_.player)
            return {StatusCode::Unsupported, "a take is being replayed; load a scenario to record"};
        session_.setRecording(message.on, &client_);
        return {};
    }

    Status operator()(const protocol::Seek& message) {
        if (!session_.player) return {StatusCode::Unsupported, "no take is open"};
        session_.player->want(message.step);
        return {};
    }

    Status operator()(const protocol::TakeAgain& message) {
        return session_.takeAgain(message.keep, client_);
    }

    Status operator()(const protocol::EditTake& message) { return session_.editTake(message); }
    Status operator()(const protocol::AskPath& message) { return session_.askPath(client_, message); }
    Status operator()(const protocol::BendPath& message) { return session_.changePath(message); }
    Status operator()(const protocol::EditPeople& message) { return session_.editPeople(message); }

    Status operator()(const protocol::WatchTracks& message) {
        client_.watchesTracks = message.on;
        client_.sentTracks = 0;
        return {};
    }
    Status operator()(const protocol::EditTrack& message) { return session_.changeTracks(message); }

    Status operator()(const protocol::SetOverlay& message) {
        if (message.kind == protocol::OverlayKind::Cost) {
            if (!session_.world) return noWorld();
            const std::span ids = session_.world->characters().id;
            if (std::find(ids.begin(), ids.end(), message.character) == ids.end())
                return {StatusCode::NotFound, "no character has the id " + std::to_string(message.character)};
        }
        client_.overlay = message.kind;
        client_.overlayCharacter = message.character;
        client_.overlayState = 0;  // Sends an overlay even while the world is paused.
        return {};
    }

    Status operator()(const protocol::WatchStages& message) {
        client_.watchesStages = message.on;
        client_.sentStages = session_.stages.revision();  // What it hears of comes after this.
        return {};
    }

    Status operator()(const protocol::Commands& message) {
        if (!session_.world) return noWorld();
        TouchClock clock = client_.clock;  // Stored only if every command of the message is valid.
        double newest = client_.touchWaiting;
        auto bodies = readDirections(message.commands, session_.def.limits, [&](double pageTime) {
            newest = std::max(newest, pageTime);
            return stamp(clock, pageTime);
        });
        if (!bodies.ok()) return bodies.status();
        const Status status = submit(std::move(bodies).value());
        if (!status.ok()) return status;
        client_.clock = clock;
        client_.touchWaiting = newest;
        return status;
    }

    Status operator()(const protocol::Attend& message) {
        const std::size_t most = session_.def.limits.wholePoses;
        if (message.count > most) return limitExceeded("whole poses asked for", message.count, most);
        if (!std::isfinite(message.x) || !std::isfinite(message.y))
            return invalidArgument("a spot to look at that is not finite");
        client_.attention = {{message.x, message.y}, message.count};
        return {};
    }

    Status operator()(const protocol::FrameAck& message) { return client_.frames.acknowledge(message.frame); }

    Status operator()(const protocol::Ping& message) {
        protocol::Pong pong;
        pong.time = message.time;
        client_.outbox.push_back(protocol::encode(pong));
        return {};
    }

    Status operator()(const protocol::AskForecasts& message) {
        if (!session_.world) return noWorld();
        const SessionLimits& limits = session_.def.limits;
        if (Status status = takeForecasts(message.asks.size()); !status.ok()) return status;
        const auto answer = answerForecasts(*session_.world, message, limits);
        if (!answer.ok()) return answer.status();
        client_.outbox.push_back(protocol::encode(answer.value()));
        return {};
    }

    Status operator()(const protocol::AskPlaces& message) {
        if (!session_.world) return noWorld();
        const SessionLimits& limits = session_.def.limits;
        if (Status status = takeForecasts(message.asks.size()); !status.ok()) return status;
        const auto answer = answerPlaces(*session_.world, message, limits);
        if (!answer.ok()) return answer.status();
        client_.outbox.push_back(protocol::encode(answer.value()));
        return {};
    }

    Status operator()(const protocol::AskStandings& message) {
        if (!session_.world) return noWorld();
        if (Status status = takeForecasts(1); !status.ok()) return status;
        client_.outbox.push_back(protocol::encode(answerStandings(*session_.world, message)));
        return {};
    }

    Status operator()(const protocol::Say& message) {
        if (message.act == protocol::SayAct::Preview)
            if (Status status = takeForecasts(1); !status.ok()) return status;
        const auto said = session_.say(client_, message);
        if (!said.ok()) return said.status();
        client_.outbox.push_back(protocol::encode(said.value()));
        return {};
    }

    Status operator()(const protocol::SetScheme& message) {
        if (client_.steers && session_.world && !session_.player) {
            if (Status status = submit(CommandBody{ReleaseClient{}}); !status.ok()) return status;
        }
        return client_.scheme.choose(message.name, client_.number);
    }

    Status operator()(const protocol::SetView& message) {
        const auto view = groundViewOf(message);
        if (!view.ok()) return view.status();
        client_.scheme.setView(view.value(), session_.world ? &*session_.world : nullptr);
        return {};
    }

    Status operator()(const protocol::Inputs& message) {
        if (!session_.world) return noWorld();
        if (session_.player) return replays();
        if (Status status = checkInputs(message, session_.def.limits); !status.ok()) return status;
        if (!client_.touches.take(session_.realTime, static_cast<double>(message.events.size())))
            return tooManyTouches("inputs");
        for (const protocol::RawInput& raw : message.events) {
            const InputEvent event = inputOf(raw, stamp(client_.clock, raw.time));
            if (Status status = client_.scheme.input(event, *session_.world); !status.ok()) return status;
            client_.touchWaiting = std::max(client_.touchWaiting, raw.time);
        }
        session_.inputsWait = true;
        session_.handCame();
        return {};
    }

    Status operator()(const protocol::Edit& message) { return session_.edit(client_, message); }
    Status operator()(const protocol::UndoEdit& message) { return session_.undoEdit(client_, message.redo); }

    Status operator()(const protocol::AskOthers& message) { return session_.askOthers(client_, message); }
    Status operator()(const protocol::AnswerAsk& message) { return session_.answerAsk(client_, message); }
    Status operator()(const protocol::Build& message) { return session_.build(client_, message.on); }
    Status operator()(const protocol::KeepPlace& message) { return session_.keepPlace(client_, message); }

    Status operator()(const protocol::EnterStudy&) { return noStudy(); }
    Status operator()(const protocol::AnswerForm&) { return noStudy(); }
    Status operator()(const protocol::DoInStudy&) { return noStudy(); }

private:
    static Status noStudy() {
        return {StatusCode::Unsupported, "this is the studio; 'muster study run' serves the study"};
    }
    static Status replays() {
        return {StatusCode::Unsupported, "a take is being replayed; load a scenario to steer"};
    }
    Status tooManyTouches(const std::string& what) const {
        return {StatusCode::LimitExceeded,
                "more than " + std::to_string(static_cast<int>(session_.def.limits.touchesPerSecond)) + " " +
                    what + " a second"};
    }
    /// Counts questions about orders and places.
    Status takeForecasts(std::size_t count) {
        if (client_.forecasts.take(session_.realTime, static_cast<double>(count))) return {};
        return {StatusCode::LimitExceeded,
                "more than " + std::to_string(static_cast<int>(session_.def.limits.forecastsPerSecond)) +
                    " forecasts a second"};
    }
    static Status noWorld() { return {StatusCode::NotFound, "there is no world yet"}; }
    static Status noGroup(std::uint32_t id) {
        return {StatusCode::NotFound, "no group has the id " + std::to_string(id)};
    }

    const GroupDef* groupDef(std::uint32_t id) const {
        if (!session_.world) return nullptr;
        const auto g = inspect::indexOfGroup(*session_.world, GroupId{id});
        return g ? &inspect::groupDef(*session_.world, *g) : nullptr;
    }

    double stamp(TouchClock& clock, double pageTime) const {
        const double now = session_.world ? session_.world->time() : 0.0;
        return clock.stamp(pageTime, session_.realTime, now, session_.playing ? session_.speed : 0.0);
    }

    Status submit(CommandBody body) {
        std::vector<CommandBody> bodies;
        bodies.push_back(std::move(body));
        return session_.act(client_, std::move(bodies));
    }
    Status submit(std::vector<CommandBody> bodies) { return session_.act(client_, std::move(bodies)); }

    Session::Impl& session_;
    SessionClient& client_;
};

}  // namespace

void Session::receive(std::uint32_t client, std::span<const std::uint8_t> bytes) {
    const auto found = impl_->clients.find(client);
    if (found == impl_->clients.end()) return;
    const auto message = protocol::decodeClient(bytes);
    if (!message.ok()) {
        impl_->notice(found->second, protocol::NoticeLevel::Error, "malformed", message.status().message());
        return;
    }
    const Status status = impl_->handle(found->second, message.value());
    if (status.ok()) return;
    impl_->notice(found->second, protocol::NoticeLevel::Error, protocol::messageName(message.value()),
                  status.message(), positionOf(message.value()));
}

Status Session::Impl::handle(SessionClient& client, const protocol::ClientMessage& message) {
    if (!client.greeted && !std::holds_alternative<protocol::Hello>(message))
        return invalidArgument("found no Hello yet, expected it first");
    return std::visit(Handler(*this, client), message);
}

Status Session::Impl::submit(SessionClient& client, std::vector<CommandBody>& bodies, bool steers) {
    if (!world) return {StatusCode::NotFound, "there is no world yet"};
    if (player) return {StatusCode::Unsupported, "a take is being replayed; load a scenario to steer"};
    // Lifting the fingers of a client that has left bypasses the limit; this happens once per client.
    const bool released = bodies.size() == 1 && std::holds_alternative<ReleaseClient>(bodies.front());
    if (!released && waitingCommands + bodies.size() > def.limits.waitingCommands) {
        return {StatusCode::LimitExceeded, "more than " + std::to_string(def.limits.waitingCommands) +
                                               " commands wait for the next step"};
    }
    for (CommandBody& body : bodies)
        if (const Status status = directors.admit(client.number, body); !status.ok()) return status;
    std::vector<Command> commands;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        commands.push_back({world->stepCount(), client.number,
                            client.sequence + static_cast<std::uint32_t>(i) + 1, std::move(bodies[i])});
        if (const Status status = validateCommand(commands.back()); !status.ok()) return status;
    }
    for (const Command& command : commands) {
        const Status status = world->submit(command);
        if (!status.ok()) return status;
        log.command(command);
        client.sequence = command.sequence;
        client.steers = true;
        ++waitingCommands;
    }
    if (!released && steers) handCame();
    return {};
}

void Session::Impl::handCame() {
    if (!waitsForHand) return;
    resume();
    touchState();
}

}  // namespace muster
