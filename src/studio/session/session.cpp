#include <algorithm>

#include "muster/own_clips.h"
#include "muster/scenario.h"
#include "studio/session/frames/notices.h"
#include "studio/session/frames/scene_message.h"
#include "studio/session/frames/scene_signature.h"
#include "studio/session/session_state.h"

namespace muster {
namespace {

constexpr const char* kHeldAlready =
    "that part of the formation is held already; let go of it first (Esc), or take hold elsewhere";

// Events kept for a client that takes no frames; older ones are dropped.
constexpr std::size_t kMaxEvents = 4096;

}  // namespace

Session::Session(SessionDef def) : impl_(std::make_unique<Impl>(std::move(def))) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

// ---- Worlds ----

Status Session::Impl::begin(const std::string& worldName, const WorldDef& newDef,
                            std::unique_ptr<TakePlayer> taken) {
    auto made = World::create(newDef, def.threads);
    if (!made.ok()) return made.status();
    beginWith(std::move(made).value(), worldName, newDef, std::move(taken));
    return {};
}

void Session::Impl::beginWith(World begun, const std::string& worldName, const WorldDef& newDef,
                              std::unique_ptr<TakePlayer> taken) {
    stopRecording();
    if (leaving) park(taken != nullptr);
    world.emplace(std::move(begun));
    if (&worldDef != &newDef) worldDef = newDef, warn();
    editor.begin(worldDef);
    givenEdits.clear();
    spoken.clear();
    ++worldNumber;
    name = worldName;
    if (player || taken) touchTake(), ++editsRevision;
    player = std::move(taken);
    ++takeNumber;
    versions.clear();
    tracksChange = false;
    if (!player) {
        log.begin(worldDef, def.limits.takeBytes);
        takenBytes.clear();
    }
    layer.clear();
    waitsForHand = false;
    endSaid = false;
    recorded = false;
    fullReported = false;
    demonstratedUntil = 0;
    waitingCommands = 0;
    singleSteps = 0;
    pacer.reset();
    shared.goesOn = !shared.builders.empty();  // Who builds goes on building.
    playing = shared.builders.empty();
    shared.pausedBy = 0;
    shared.touch();
    frames.restart();
    standings.restart();
    stages.forget();
    directors.forgetGroups();
    beginMotion();
    if (player) player->keep(*world, motion);
    refreshScene();
    touchState();
    forgetClients();
    if (!player && def.opened) def.opened(name);
}

// What clients did belongs to the world before.
void Session::Impl::forgetClients() {
    for (auto& [id, client] : clients) {
        client.clock.restart();
        client.sequence = 0;
        client.steers = false;
        client.events.clear();
        client.frames.restart();
        client.scheme.restart(client.number);
        client.touchWaiting = client.touchShown = 0.0;
    }
}

// Characters play Muster's own clips where the scenario names clips that cannot be read.
void Session::Impl::beginMotion() {
    auto clips = def.loadClips ? def.loadClips(name, worldDef) : Result<ClipLibrary>(ownClips());
    if (Status s = clips.ok() ? MotionFrames::fits(*clips) : Status(); !s.ok()) clips = std::move(s);
    clipsRead = clips.status();
    for (auto& [id, client] : clients)
        if (client.greeted) warnOfClips(client);
    motion.restart(clips.ok() ? std::move(clips).value() : ownClips(),
                   player != nullptr && MotionFrames::tracksAll(worldDef));
    if (player) player->setEdits(player->about().edits, motion.library());
    observeMotion();
}

void Session::Impl::observeMotion() {
    attentions.clear();
    for (const auto& [id, client] : clients) attentions.push_back(client.attention);
    motion.observe(*world, attentions, shown());
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
    if (player) {
        player->want(player->first());
        resume();
        pacer.reset();
        touchState();
        return {};
    }
    const bool recording = recordedFrom >= 0.0;
    stopRecording(true);
    if (Status s = beginAgain(); !s.ok()) return s;
    if (recording) setRecording(true, nullptr);
    return {};
}

// Submits all touches before the first step, as `muster play --gestures` does, because waiting commands are
// part of the hash.
Status Session::Impl::demonstrate() {
    if (!world) return {StatusCode::NotFound, "there is no world yet"};
    if (player)
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
    const bool recording = recordedFrom >= 0.0;
    stopRecording(true);
    if (Status s = beginAgain(); !s.ok()) return s;
    if (recording) setRecording(true, nullptr);
    for (const Command& command : *commands) {
        if (Status s = world->submit(command); !s.ok()) return s.within(worldDef.gestures);
        log.command(command);
        demonstratedUntil = std::max(demonstratedUntil, command.step + 1);
    }
    return {};
}

Status Session::load(const std::string& name, const WorldDef& def) {
    return impl_->begin(name, def);
}

const World* Session::world() const {
    return impl_->world ? &*impl_->world : nullptr;
}
bool Session::playing() const {
    return impl_->playing;
}
bool Session::replaying() const {
    return impl_->player != nullptr;
}
bool Session::demonstrating() const {
    return impl_->demonstrating();
}

// ---- Steps ----

void Session::elapse(double seconds) {
    impl_->realTime += std::max(0.0, seconds);
    impl_->settleAsk();
    if (impl_->world && impl_->playing)
        impl_->pacer.elapse(seconds, impl_->pace(), impl_->world->parameters().stepTime);
}

bool Session::stepDue() const {
    if (!impl_->world) return false;
    if (impl_->player && impl_->player->seeking()) return true;
    if (!impl_->playing) return impl_->singleSteps > 0;
    return impl_->pacer.due(impl_->world->parameters().stepTime, impl_->eager());
}

double Session::untilNextStep() const {
    if (!impl_->world) return kLongWait;
    if (impl_->player && impl_->player->seeking()) return 0.0;
    if (!impl_->playing) return impl_->singleSteps > 0 ? 0.0 : kLongWait;
    return impl_->pacer.until(impl_->pace(), impl_->world->parameters().stepTime, impl_->eager());
}

void Session::step() {
    if (impl_->player && impl_->player->seeking()) return impl_->seek();
    const std::int32_t batch = impl_->playing ? Pacer::batch(impl_->pace()) : 1;
    for (std::int32_t i = 0; i < batch && stepDue(); ++i) {
        if (impl_->player && impl_->player->seeking()) return;
        if (impl_->playing)
            impl_->pacer.pay(impl_->world->parameters().stepTime);
        else
            --impl_->singleSteps;
        impl_->stepOnce();
    }
}

void Session::Impl::stepOnce() {
    if (player)
        stepReplay();
    else
        stepWorld();
}

// What follows from every step.
void Session::Impl::stepped() {
    waitingCommands = 0;
    inputsWait = false;
    touchState();
    frames.observe(*world);
    directors.observe(*world);
    observeMotion();
    observeStages();
}

// Nothing is summed while nobody watches.
void Session::Impl::observeStages() {
    const bool watched = std::any_of(clients.begin(), clients.end(),
                                     [](const auto& entry) { return entry.second.watchesStages; });
    if (watched)
        stages.observe(*world);
    else
        stages.forget();
}

void Session::Impl::stepWorld() {
    submitLayer();
    submitEdits();
    driveSchemes();
    world->step();
    stepped();
    log.observe(*world);
    editsCarriedOut();
    submitSpoken();
    if (log.full() && !fullReported) {
        fullReported = true;
        noticeAll(protocol::NoticeLevel::Warning, "take-full",
                  "The take is full; restart to record a new one.");
    }
    noticeEvents();
    queueEvents();
    reportRejections();
    reportLostFile();
    if (sceneSignature(*world) != signature) refreshScene();
}

void Session::Impl::driveSchemes() {
    for (auto& [id, client] : clients) {
        std::vector<CommandBody> bodies = client.scheme.take(*world);
        if (bodies.empty()) continue;
        const Status status = act(client, std::move(bodies));
        if (!status.ok()) notice(client, protocol::NoticeLevel::Error, "Inputs", status.message());
    }
}

// Events wait for the next frame of each client.
void Session::Impl::queueEvents() {
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
}

void Session::Impl::reportRejections() {
    for (const Rejection& rejection : world->rejections()) {
        const CommandBody& body = rejection.command.body;
        // A finger whose beginning was refused causes no further notices.
        if (const auto* touch = std::get_if<Touch>(&body);
            touch != nullptr && touch->phase != TouchPhase::Down)
            continue;
        // Who lets go twice has what they want.
        const auto* edit = std::get_if<EditControl>(&body);
        if (edit != nullptr && edit->edit == ControlEdit::Remove &&
            rejection.status.code() == StatusCode::NotFound)
            continue;
        const bool adds = std::holds_alternative<AddControl>(body) &&
                          rejection.status.code() != StatusCode::NotFound;
        if (SessionClient* const client = clientOf(rejection.command.client))
            notice(*client, protocol::NoticeLevel::Warning, "rejected",
                   adds ? kHeldAlready : rejection.status.message(), positionOf(body));
    }
}

void Session::Impl::noticeEvents() {
    std::vector<EventNotice> notices;
    appendNotices(*world, notices);
    standings.observe(*world, notices);
    for (const EventNotice& one : notices) noticeAll(one.level, one.code, one.text, one.position);
}

void Session::Impl::refreshScene() {
    signature = sceneSignature(*world);
    ++sceneRevision;
    sceneBytes = protocol::encode(
        sceneMessage({name, worldDef, *world, editor.place(), worldNumber, canDemonstrate()}, sceneRevision));
    touchState();
}

}  // namespace muster
