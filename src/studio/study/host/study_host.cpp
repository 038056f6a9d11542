#include "studio/study/host/study_host.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studio/session/inbox/chosen_scheme.h"
#include "studio/study/host/trial_screen.h"

namespace muster {
namespace {

constexpr std::size_t kNoRun = static_cast<std::size_t>(-1);

}  // namespace

/// A page.
struct StudyHost::Client {
    explicit Client(const SessionLimits& limits)
        : notices(limits.noticesPerSecond, limits.noticesPerSecond) {}

    bool greeted = false;
    std::size_t run = kNoRun;  // Index of its run.
    TokenBucket notices;
    std::vector<MessageBytes> outbox;
};

StudyHost::StudyHost(StudyStore& store, StudyHostDef def) : store_(store), def_(std::move(def)) {}
StudyHost::~StudyHost() = default;

// ---- Messages ----

/// Handles one message of a page.
class StudyHost::Handler {
public:
    Handler(StudyHost& host, std::uint32_t id, Client& client) : host_(host), id_(id), client_(client) {}

    Status operator()(const protocol::Hello&) {
        if (client_.greeted) return invalidArgument("a second Hello");
        host_.greet(id_, client_);
        return {};
    }
    Status operator()(const protocol::EnterStudy& message) {
        return host_.enter(id_, client_, message.token);
    }
    Status operator()(const protocol::AnswerForm& message) {
        if (message.answers.size() > kMostAnswers)
            return invalidArgument("found " + std::to_string(message.answers.size()) +
                                   " answers to one form, expected at most " + std::to_string(kMostAnswers));
        HostedRun* run = host_.runOf(client_);
        return run != nullptr ? run->answer(message) : host_.begin(client_, message);
    }
    Status operator()(const protocol::DoInStudy& message) {
        return withRun([&](HostedRun& run) { return run.act(message.act); });
    }
    Status operator()(const protocol::SetView& message) {
        return withRun([&](HostedRun& run) { return run.setView(message); });
    }
    Status operator()(const protocol::Inputs& message) {
        return withRun([&](HostedRun& run) { return run.inputs(message, host_.def_.limits); });
    }
    Status operator()(const protocol::FrameAck& message) {
        HostedRun* run = host_.runOf(client_);
        // An acknowledgement of a page that another one has replaced is nothing to complain of.
        return run != nullptr ? run->acknowledge(message.frame) : Status();
    }
    Status operator()(const protocol::Attend& message) {
        if (message.count > host_.def_.limits.wholePoses || !std::isfinite(message.x) ||
            !std::isfinite(message.y))
            return invalidArgument("found a spot to look at that is not finite, or too many poses");
        HostedRun* run = host_.runOf(client_);
        if (run != nullptr) run->attend({{message.x, message.y}, message.count});
        return {};
    }
    Status operator()(const protocol::Ping& message) {
        protocol::Pong pong;
        pong.time = message.time;
        client_.outbox.push_back(protocol::encode(pong));
        return {};
    }
    template <class Other>
    Status operator()(const Other&) {
        return {StatusCode::Unsupported, "the study knows no such message"};
    }

private:
    static constexpr std::size_t kMostAnswers = 100;

    template <class Act>
    Status withRun(const Act& act) {
        HostedRun* run = host_.runOf(client_);
        return run != nullptr ? act(*run) : Status(StatusCode::NotFound, "no run has begun");
    }

    StudyHost& host_;
    std::uint32_t id_;
    Client& client_;
};

void StudyHost::receive(std::uint32_t client, std::span<const std::uint8_t> bytes) {
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    const auto message = protocol::decodeClient(bytes);
    if (!message.ok()) return notice(client, true, "malformed", message.status().message());
    const bool early = !found->second.greeted && !std::holds_alternative<protocol::Hello>(message.value());
    const Status status = early ? invalidArgument("found no Hello yet, expected it first")
                                : std::visit(Handler(*this, client, found->second), message.value());
    if (!status.ok()) notice(client, true, protocol::messageName(message.value()), status.message());
}

// ---- Pages ----

std::uint32_t StudyHost::connect() {
    clients_.emplace(++lastClient_, Client(def_.limits));
    return lastClient_;
}

void StudyHost::disconnect(std::uint32_t client) {
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    if (HostedRun* run = runOf(found->second)) run->detach();
    clients_.erase(found);
}

HostedRun* StudyHost::runOf(const Client& client) {
    return client.run == kNoRun ? nullptr : runs_[client.run].get();
}

void StudyHost::notice(std::uint32_t client, bool error, const std::string& code, const std::string& text) {
    const auto found = clients_.find(client);
    if (found == clients_.end() || !found->second.notices.take(realTime_)) return;
    protocol::Notice message;
    message.level = error ? protocol::NoticeLevel::Error : protocol::NoticeLevel::Info;
    message.code = code;
    message.text = text;
    found->second.outbox.push_back(protocol::encode(message));
}

void StudyHost::greet(std::uint32_t id, Client& client) {
    client.greeted = true;
    protocol::Welcome welcome;
    welcome.client = id;
    welcome.version = def_.version;
    for (const NamedScheme& scheme : namedSchemes()) welcome.schemes.push_back(infoOf(scheme));
    client.outbox.push_back(protocol::encode(welcome));
}

// Before consent there is no run: a page that is only looked at leaves nothing behind.
void StudyHost::sendConsent(Client& client) const {
    protocol::StudyState state;
    state.test = def_.kind == RunKind::Test;
    client.outbox.push_back(protocol::encode(state));
    client.outbox.push_back(protocol::encode(formOf(studyForms().front(), {})));
}

Status StudyHost::enter(std::uint32_t id, Client& client, const std::string& token) {
    if (client.run != kNoRun) return invalidArgument("this page has a run already");
    const auto found = std::find_if(runs_.begin(), runs_.end(),
                                    [&](const auto& run) { return run->token() == token; });
    if (token.empty() || found == runs_.end()) {
        sendConsent(client);
        return {};
    }
    const auto index = static_cast<std::size_t>(found - runs_.begin());
    // Its page before this one may not have noticed that it was lost, or is another window.
    for (auto& [other, one] : clients_) {
        if (other == id || one.run != index) continue;
        (*found)->detach();
        one.run = kNoRun;
        protocol::StudyState state;
        state.stage = protocol::StudyStage::Elsewhere;
        one.outbox.push_back(protocol::encode(state));
    }
    client.run = index;
    (*found)->attach();
    return {};
}

Status StudyHost::begin(Client& client, const protocol::AnswerForm& consent) {
    // A run begins with a consent that is complete, so that a wrong one leaves nothing behind.
    const std::vector<StudyAnswer> answers = answersOf(consent, {});
    if (Status status = checkForm(studyForms().front(), answers); !status.ok()) return status;
    auto made = PersonRun::begin(store_, def_.settings, def_.kind, def_.now(), def_.version);
    if (!made.ok()) return made.status();
    runs_.push_back(std::make_unique<HostedRun>(std::move(made).value(), def_.token()));
    client.run = runs_.size() - 1;
    runs_.back()->attach();
    return runs_.back()->answer(consent);
}

void StudyHost::outgoing(std::uint32_t client, std::vector<MessageBytes>& messages) {
    messages.clear();
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    messages.swap(found->second.outbox);
    if (HostedRun* run = runOf(found->second)) run->outgoing(messages);
}

// ---- Time ----

void StudyHost::elapse(double seconds) {
    realTime_ += std::max(0.0, seconds);
    for (const auto& run : runs_) run->elapse(std::max(0.0, seconds));
}

bool StudyHost::stepDue() const {
    return std::any_of(runs_.begin(), runs_.end(), [](const auto& run) { return run->stepDue(); });
}

void StudyHost::step() {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (!runs_[i]->stepDue()) continue;
        const Status status = runs_[i]->step();
        if (status.ok()) continue;
        for (const auto& [id, client] : clients_)
            if (client.run == i) notice(id, true, "store", status.message());
    }
}

double StudyHost::untilNextStep() const {
    double least = kLongWait;
    for (const auto& run : runs_) least = std::min(least, run->untilNextStep());
    return least;
}

void StudyHost::finish() {
    for (const auto& run : runs_) (void)run->breakOff();  // What cannot be stored stays marked as running.
}

}  // namespace muster
