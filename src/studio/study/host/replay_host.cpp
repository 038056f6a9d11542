#include "studio/study/host/replay_host.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/token_bucket.h"
#include "studio/session/inbox/chosen_scheme.h"
#include "studio/study/host/trial_screen.h"

namespace muster {

/// A page.
struct ReplayHost::Client {
    explicit Client(const SessionLimits& limits)
        : notices(limits.noticesPerSecond, limits.noticesPerSecond) {}

    bool greeted = false;
    FrameSender sender;
    Attention attention;
    std::uint64_t sentState = 0;
    MessageBytes sentMarks;
    TokenBucket notices;
    std::vector<MessageBytes> outbox;
};

ReplayHost::ReplayHost(TrialReplay replay, ReplayHostDef def)
    : replay_(std::move(replay)), def_(std::move(def)) {
    screen_.begin(replay_.trial());
}
ReplayHost::~ReplayHost() = default;

/// Handles one message of a page.
class ReplayHost::Handler {
public:
    Handler(ReplayHost& host, std::uint32_t id, Client& client) : host_(host), id_(id), client_(client) {}

    Status operator()(const protocol::Hello&) {
        if (client_.greeted) return invalidArgument("a second Hello");
        client_.greeted = true;
        protocol::Welcome welcome;
        welcome.client = id_;
        welcome.version = host_.def_.version;
        for (const NamedScheme& scheme : namedSchemes()) welcome.schemes.push_back(infoOf(scheme));
        client_.outbox.push_back(protocol::encode(welcome));
        client_.outbox.push_back(protocol::encode(host_.state()));
        return {};
    }
    Status operator()(const protocol::EnterStudy&) { return {}; }
    Status operator()(const protocol::SetView&) { return {}; }
    Status operator()(const protocol::FrameAck& message) { return client_.sender.acknowledge(message.frame); }
    Status operator()(const protocol::Attend& message) {
        if (message.count > host_.def_.limits.wholePoses || !std::isfinite(message.x) ||
            !std::isfinite(message.y))
            return invalidArgument("found a spot to look at that is not finite, or too many poses");
        client_.attention = {{message.x, message.y}, message.count};
        return {};
    }
    Status operator()(const protocol::Ping& message) {
        protocol::Pong pong;
        pong.time = message.time;
        client_.outbox.push_back(protocol::encode(pong));
        return {};
    }
    Status operator()(const protocol::SetSpeed& message) {
        if (!(message.factor >= 0.1f && message.factor <= 8.0f))
            return invalidArgument("found a speed of " + std::to_string(message.factor) +
                                   ", expected 0.1 to 8");
        host_.speed_ = message.factor;
        host_.screen_.touch();
        return {};
    }
    Status operator()(const protocol::Playback& message) {
        using enum protocol::PlaybackAction;
        if (message.action == Play && !host_.replay_.atEnd())
            host_.setPlaying(true);
        else if (message.action == Pause)
            host_.setPlaying(false);
        else if (message.action == Play || message.action == Restart)
            return host_.restart();
        else
            return {StatusCode::Unsupported, "the replay of a trial plays, pauses and begins again"};
        return {};
    }
    template <class Other>
    Status operator()(const Other&) {
        return {StatusCode::Unsupported, "a trial is being replayed; nothing can be changed in it"};
    }

private:
    ReplayHost& host_;
    std::uint32_t id_;
    Client& client_;
};

protocol::StudyState ReplayHost::state() const {
    protocol::StudyState message;
    message.stage = protocol::StudyStage::Replay;
    message.run = static_cast<std::uint32_t>(def_.trial.run);
    message.test = def_.kind == RunKind::Test;
    message.trial = static_cast<std::uint32_t>(def_.trial.id);
    message.practice = def_.trial.practice;
    describeTrial(def_.trial.def, message);
    message.limit = replay_.steps() * replay_.trial().world().parameters().stepTime;
    message.ended = endOf(def_.trial);
    message.seconds = def_.trial.result.seconds;
    message.collected = static_cast<std::uint32_t>(def_.trial.result.collected);
    return message;
}

void ReplayHost::receive(std::uint32_t client, std::span<const std::uint8_t> bytes) {
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    const auto message = protocol::decodeClient(bytes);
    if (!message.ok()) return notice(client, true, "malformed", message.status().message());
    const bool early = !found->second.greeted && !std::holds_alternative<protocol::Hello>(message.value());
    const Status status = early ? invalidArgument("found no Hello yet, expected it first")
                                : std::visit(Handler(*this, client, found->second), message.value());
    if (!status.ok()) notice(client, true, protocol::messageName(message.value()), status.message());
}

std::uint32_t ReplayHost::connect() {
    clients_.emplace(++lastClient_, Client(def_.limits));
    return lastClient_;
}

void ReplayHost::disconnect(std::uint32_t client) {
    clients_.erase(client);
}

void ReplayHost::notice(std::uint32_t client, bool error, const std::string& code, const std::string& text) {
    const auto found = clients_.find(client);
    if (found == clients_.end() || !found->second.notices.take(realTime_)) return;
    protocol::Notice message;
    message.level = error ? protocol::NoticeLevel::Error : protocol::NoticeLevel::Info;
    message.code = code;
    message.text = text;
    found->second.outbox.push_back(protocol::encode(message));
}

void ReplayHost::sendAll(const MessageBytes& message) {
    for (auto& [id, client] : clients_)
        if (client.greeted) client.outbox.push_back(message);
}

void ReplayHost::outgoing(std::uint32_t client, std::vector<MessageBytes>& messages) {
    messages.clear();
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    Client& to = found->second;
    messages.swap(to.outbox);
    if (!to.greeted || to.sender.waits() || to.sentState == screen_.state()) return;
    const Trial& trial = replay_.trial();
    protocol::Marks marks = marksOf(trial.def().scheme, trial.scheme().marks());
    marks.pointers = pairsOf(replay_.pointers());
    MessageBytes bytes = protocol::encode(marks);
    if (bytes != to.sentMarks) {
        messages.push_back(bytes);
        to.sentMarks = std::move(bytes);
    }
    screen_.send(trial, playing_, speed_, 0.0, to.sender, messages);
    to.sentState = screen_.state();
}

// ---- Time ----

void ReplayHost::setPlaying(bool playing) {
    playing_ = playing;
    pacer_.reset();
    screen_.touch();
}

Status ReplayHost::restart() {
    if (Status status = replay_.restart(); !status.ok()) return status;
    screen_.begin(replay_.trial());
    for (auto& [id, client] : clients_) client.sender.restart();
    setPlaying(true);
    return {};
}

void ReplayHost::elapse(double seconds) {
    realTime_ += std::max(0.0, seconds);
    if (playing_) pacer_.elapse(seconds, speed_, replay_.trial().world().parameters().stepTime);
}

bool ReplayHost::stepDue() const {
    return playing_ && pacer_.due(replay_.trial().world().parameters().stepTime, false);
}

double ReplayHost::untilNextStep() const {
    if (!playing_) return kLongWait;
    return pacer_.until(speed_, replay_.trial().world().parameters().stepTime, false);
}

void ReplayHost::step() {
    const std::int32_t batch = Pacer::batch(speed_);
    for (std::int32_t i = 0; i < batch && stepDue(); ++i) {
        pacer_.pay(replay_.trial().world().parameters().stepTime);
        stepOnce();
    }
}

void ReplayHost::stepOnce() {
    const Status status = replay_.atEnd() ? Status() : replay_.step();
    if (status.ok()) {
        std::vector<Attention> attentions;
        for (const auto& [id, client] : clients_) attentions.push_back(client.attention);
        screen_.observe(replay_.trial(), attentions);
    }
    if (status.ok() && !replay_.atEnd()) return;
    setPlaying(false);
    protocol::Notice message;
    message.code = "replay-end";
    message.text = "The trial ends here; its hash is the stored one.";
    if (!status.ok() || def_.trial.state == RunState::Running ||
        replay_.trial().world().hash() != def_.trial.result.hash) {
        message.level = protocol::NoticeLevel::Warning;
        message.text = !status.ok() ? "An input of the trial cannot be replayed: " + status.message()
                       : def_.trial.state == RunState::Running
                           ? "The trial was cut off here, so that no hash is stored."
                           : "The trial ends here with another hash than the stored one.";
    }
    sendAll(protocol::encode(message));
}

}  // namespace muster
