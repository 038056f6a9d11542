#include <algorithm>

#include "io/take/take_encoder.h"
#include "muster/own_clips.h"
#include "muster/scenario.h"
#include "session/event_notices.h"
#include "session/notice_position.h"
#include "session/scene_json.h"
#include "session/session_state.h"

namespace muster {
namespace {

constexpr double kLongWait = 1.0;  // Reported as the time to the next step while paused [s].
// Events kept for a client that takes no frames; older ones are dropped.
constexpr std::size_t kMaxEvents = 4096;

}  // namespace

Session::Session(SessionDef def) : impl_(std::make_unique<Impl>(std::move(def))) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

// ---- Worlds ----

Status Session::Impl::begin(const std::string& worldName, const WorldDef& newDef,
                            std::shared_ptr<const Take> take) {
    auto made = World::create(newDef, def.threads);
    if (!made.ok()) return made.status();
    stopRecording();
    world.emplace(std::move(made).value());
    if (&worldDef != &newDef) worldDef = newDef, warn();
    name = worldName;
    replay.reset();
    replayedTake = std::move(take);
    if (replayedTake)
        replay.emplace(*replayedTake);
    else
        log.begin(worldDef, def.limits.takeBytes);
    fullReported = false;
    demonstratedUntil = 0;
    waitingCommands = 0;
    singleSteps = 0;
    pacer.reset();
    playing = true;
    frames.restart();
    directors.forgetGroups();
    beginMotion();
    refreshScene();
    touchState();
    for (auto& [id, client] : clients) {
        client.clock.restart();
        client.sequence = 0;
        client.steers = false;
        client.events.clear();
        client.sentMeshes.clear();
        client.touchWaiting = client.touchShown = 0.0;
    }
    return {};
}

// Characters play Muster's own clips where the scenario names clips that cannot be read.
void Session::Impl::beginMotion() {
    auto clips = def.loadClips ? def.loadClips(name, worldDef) : Result<ClipLibrary>(ownClips());
    if (Status s = clips.ok() ? MotionFrames::fits(*clips) : Status(); !s.ok()) clips = std::move(s);
    clipsRead = clips.status();
    for (auto& [id, client] : clients)
        if (client.greeted) warnOfClips(client);
    motion.restart(clips.ok() ? std::move(clips).value() : ownClips());
    observeMotion();
}

void Session::Impl::observeMotion() {
    attentions.clear();
    for (const auto& [id, client] : clients) attentions.push_back(client.attention);
    motion.observe(*world, attentions);
}

// Warnings about a scenario go once to all clients, and to clients that join later.
void Session::Impl::warn() {
    const auto warnings = scenarioWarnings(worldDef);
    warning = warnings.empty() ? "" : "Likely a mistake: " + warnings.front();
    if (warnings.size() > 1) warning += " (and " + std::to_string(warnings.size() - 1) + " more)";
    if (!warning.empty()) noticeAll(protocol::NoticeLevel::Warning, "scenario", warning + ".");
}

Status Session::Impl::restart() {
    if (!world) return {StatusCode::NotFound, "there is no world to restart"};
    return begin(name, worldDef, replayedTake);
}

// Submits all touches before the first step, as `muster play --gestures` does, because waiting commands are
// part of the hash.
Status Session::Impl::demonstrate() {
    if (!world) return {StatusCode::NotFound, "there is no world yet"};
    if (replay)
        return {StatusCode::Unsupported,
                "a take is being replayed; load a scenario to watch its demonstration"};
    if (!canDemonstrate()) return {StatusCode::NotFound, "the scenario carries no touches to watch"};
    const auto commands = def.loadGestures(name, worldDef);
    if (!commands.ok()) return commands.status();
    for (const Command& command : *commands) {
        if (command.client >= 1 && command.client <= kLastDemonstrator) continue;
        return invalidArgument(worldDef.gestures + ": found the client " + std::to_string(command.client) +
                               ", expected 1 to " + std::to_string(kLastDemonstrator) + " to be watched");
    }
    if (Status s = begin(name, worldDef, nullptr); !s.ok()) return s;
    for (const Command& command : *commands) {
        if (Status s = world->submit(command); !s.ok()) return s.within(worldDef.gestures);
        log.command(command);
        demonstratedUntil = std::max(demonstratedUntil, command.step + 1);
    }
    return {};
}

Status Session::load(const std::string& name, const WorldDef& def) {
    return impl_->begin(name, def, nullptr);
}

Status Session::openTake(std::span<const std::uint8_t> bytes, const std::string& sourceName) {
    if (bytes.size() > impl_->def.limits.openTakeBytes) {
        return {StatusCode::LimitExceeded, sourceName + ": found " + std::to_string(bytes.size()) +
                                               " bytes, expected at most " +
                                               std::to_string(impl_->def.limits.openTakeBytes)};
    }
    auto take = parseTake(bytes, sourceName);
    if (!take.ok()) return take.status();
    if (take->steps() == 0) return invalidArgument(sourceName + ": holds no step to replay");
    const WorldDef def = take->def;
    return impl_->begin(def.name, def, std::make_shared<const Take>(std::move(take).value()));
}

Result<std::vector<std::uint8_t>> Session::take() const {
    if (!impl_->world) return Status(StatusCode::NotFound, "there is no world to keep a take of");
    if (!impl_->replay) return impl_->log.bytes(*impl_->world);
    const Take& take = *impl_->replayedTake;
    std::vector<std::uint8_t> bytes = TakeEncoder::begin(take.def);
    const auto append = [&](const std::vector<std::uint8_t>& record) {
        bytes.insert(bytes.end(), record.begin(), record.end());
    };
    std::size_t next = 0, nextEvent = 0;
    const auto appendEventsUntil = [&](std::uint32_t until) {
        for (; nextEvent < take.events.size() && take.events[nextEvent].step <= until; ++nextEvent)
            append(TakeEncoder::event(take.events[nextEvent]));
    };
    for (const HashMark& mark : take.marks) {
        appendEventsUntil(mark.step);
        for (; next < mark.commands; ++next) append(TakeEncoder::command(take.commands[next]));
        append(take.finished && &mark == &take.marks.back() ? TakeEncoder::end(mark)
                                                            : TakeEncoder::mark(mark));
    }
    for (; next < take.commands.size(); ++next) append(TakeEncoder::command(take.commands[next]));
    appendEventsUntil(take.steps());
    return bytes;
}

std::string Session::takeName() const {
    std::string name;
    for (const char c : impl_->name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        name += plain || c == '-' || c == '_' ? c : '-';
    }
    return (name.empty() ? "muster" : name.substr(0, 60)) + ".take";
}

void Session::finish() {
    impl_->stopRecording();
}

const World* Session::world() const {
    return impl_->world ? &*impl_->world : nullptr;
}
bool Session::playing() const {
    return impl_->playing;
}
bool Session::replaying() const {
    return impl_->replay.has_value();
}
bool Session::demonstrating() const {
    return impl_->demonstrating();
}

// ---- Recording ----

void Session::Impl::setRecording(bool on, std::uint32_t client) {
    if (!on) return stopRecording();
    if (recordedFrom >= 0.0) return;
    recordedFrom = world->time();
    touchState();
    if (!def.openSink) return;
    auto sink = def.openSink(name);
    const Status status = sink.ok() ? log.attach(std::move(sink).value()) : sink.status();
    if (status.ok()) return;
    const auto found = clients.find(client);
    if (found == clients.end()) return;
    notice(found->second, protocol::NoticeLevel::Warning, "record",
           "Recording in memory only: " + status.message() + ".");
}

void Session::Impl::stopRecording() {
    recordedFrom = -1.0;
    touchState();
    reportLostFile();
    if (!world || !log.attached()) return;
    const Status status = log.detach(*world);
    if (!status.ok()) noticeAll(protocol::NoticeLevel::Warning, "record", status.message());
}

// Reports once that the file cannot be written; the log in memory continues.
void Session::Impl::reportLostFile() {
    const Status status = log.takeFailure();
    if (status.ok()) return;
    noticeAll(protocol::NoticeLevel::Warning, "record",
              "Recording in memory only: " + status.message() + ".");
}

// ---- Steps ----

void Session::elapse(double seconds) {
    impl_->realTime += std::max(0.0, seconds);
    if (impl_->world && impl_->playing)
        impl_->pacer.elapse(seconds, impl_->speed, impl_->world->parameters().stepTime);
}

bool Session::stepDue() const {
    if (!impl_->world) return false;
    if (!impl_->playing) return impl_->singleSteps > 0;
    return impl_->pacer.due(impl_->world->parameters().stepTime, impl_->eager());
}

double Session::untilNextStep() const {
    if (!impl_->world) return kLongWait;
    if (!impl_->playing) return impl_->singleSteps > 0 ? 0.0 : kLongWait;
    return impl_->pacer.until(impl_->speed, impl_->world->parameters().stepTime, impl_->eager());
}

void Session::step() {
    const std::int32_t batch = impl_->playing ? Pacer::batch(impl_->speed) : 1;
    for (std::int32_t i = 0; i < batch && stepDue(); ++i) {
        if (impl_->playing)
            impl_->pacer.pay(impl_->world->parameters().stepTime);
        else
            --impl_->singleSteps;
        impl_->stepOnce();
    }
}

void Session::Impl::stepOnce() {
    if (replay && replay->atEnd(*world)) {
        replayEnded();
        return;
    }
    Status replayed;
    if (replay) replayed = replay->submit(*world);
    world->step();
    waitingCommands = 0;
    touchState();
    frames.observe(*world);
    directors.observe(*world);
    observeMotion();
    if (!replay)
        log.observe(*world);
    else if (replayed.ok())
        replayed = replay->compare(*world);
    if (!replayed.ok()) {
        playing = false;
        noticeAll(protocol::NoticeLevel::Error, "replay",
                  "The replay differs from the take: " + replayed.message());
    } else if (replay && replay->atEnd(*world)) {
        replayEnded();
    }
    if (log.full() && !fullReported && !replay) {
        fullReported = true;
        noticeAll(protocol::NoticeLevel::Warning, "take-full",
                  "The take is full; restart to record a new one.");
    }
    noticeEvents();
    stepEvents.clear();
    appendEvents(*world, stepEvents);
    for (auto& [id, client] : clients) {
        client.touchShown = std::max(client.touchShown, client.touchWaiting);
        client.events.insert(client.events.end(), stepEvents.begin(), stepEvents.end());
        if (client.events.size() > kMaxEvents) {
            const auto surplus = static_cast<std::ptrdiff_t>(client.events.size() - kMaxEvents);
            client.events.erase(client.events.begin(), client.events.begin() + surplus);
        }
    }
    reportRejections();
    reportLostFile();
    if (sceneSignature(*world) != signature) refreshScene();
}

void Session::Impl::replayEnded() {
    playing = false;
    touchState();
    std::string words = replayedTake->marks.empty() ? "The take ends here."
                                                    : "The take ends here; every hash matched.";
    if (const std::uint32_t steps = replay->unmarked(); steps > 0)
        words += " It was never finished: its last " + std::to_string(steps) + " steps bear no hash.";
    noticeAll(protocol::NoticeLevel::Info, "replay-end", words);
}

void Session::Impl::reportRejections() {
    for (const Rejection& rejection : world->rejections()) {
        const CommandBody& body = rejection.command.body;
        // A finger whose beginning was refused causes no further notices.
        if (std::holds_alternative<TouchMove>(body) || std::holds_alternative<TouchUp>(body) ||
            std::holds_alternative<TouchCancel>(body))
            continue;
        const auto found = clients.find(rejection.command.client);
        if (found != clients.end() && !replay)
            notice(found->second, protocol::NoticeLevel::Warning, "rejected", rejection.status.message(),
                   positionOf(body));
    }
}

void Session::Impl::noticeEvents() {
    std::vector<EventNotice> notices;
    appendNotices(*world, notices);
    for (const EventNotice& one : notices) noticeAll(one.level, one.code, one.text, one.position);
}

void Session::Impl::refreshScene() {
    signature = sceneSignature(*world);
    ++sceneRevision;
    protocol::Scene scene;
    scene.revision = sceneRevision;
    scene.json = buildSceneJson(name, worldDef, *world, canDemonstrate());
    sceneBytes = protocol::encode(scene);
    touchState();
}

}  // namespace muster
