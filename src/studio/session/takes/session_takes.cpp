// A session's takes: recording, replaying, going to any moment, and directing again from there.
#include <algorithm>
#include <map>
#include <set>

#include "engine/world/studio_access.h"
#include "files/take/take_encoder.h"
#include "muster/take.h"
#include "studio/session/frames/scene_signature.h"
#include "studio/session/session_state.h"
#include "studio/session/takes/take_titles.h"

namespace muster {
namespace {

constexpr int kStepsPerSeek = 90;       // Steps between two reads of the clients' messages.
constexpr double kReadySpacing = 0.25;  // Least time between two TakeReady messages [s].
constexpr double kMoment = 2.0;         // So short a recording says nothing by itself [s].

constexpr const char* kFromFrames =
    "this take was recorded by another version of Muster; it is shown from its stored frames and cannot be "
    "changed";

void append(std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& record) {
    bytes.insert(bytes.end(), record.begin(), record.end());
}

}  // namespace

// ---- Opening and keeping ----

Status Session::openTake(std::span<const std::uint8_t> bytes, const std::string& sourceName,
                         const std::string& fileName, std::uint32_t director) {
    return impl_->beginFor(impl_->idOf(director), protocol::WorldChange::Opened,
                           [&] { return impl_->openTake(bytes, sourceName, fileName); });
}

Status Session::Impl::openTake(std::span<const std::uint8_t> bytes, const std::string& sourceName,
                               const std::string& fileName) {
    if (bytes.size() > def.limits.openTakeBytes) {
        return {StatusCode::LimitExceeded, sourceName + ": found " + std::to_string(bytes.size()) +
                                               " bytes, expected at most " +
                                               std::to_string(def.limits.openTakeBytes)};
    }
    auto read = parseTake(bytes, sourceName);
    if (!read.ok()) return read.status();
    if (read->steps() == 0) return invalidArgument(sourceName + ": holds no step to replay");
    const auto take = std::make_shared<Take>(std::move(read).value());
    const bool stored = !take->frames.empty() && !simulatesAlike(*take, def.threads);
    auto opened = stored ? TakePlayer::storedFrames(take, fileName)
                         : std::make_unique<TakePlayer>(take, fileName);
    const std::vector<std::uint8_t> kept(bytes.begin(),
                                         bytes.end() - static_cast<std::ptrdiff_t>(take->tornBytes));
    if (Status s = begin(take->def.name, take->def, std::move(opened)); !s.ok()) return s;
    takenBytes = kept;
    if (player->first() > 0) player->want(player->first());
    return {};
}

Result<std::vector<std::uint8_t>> Session::take() const {
    const Impl& session = *impl_;
    if (!session.world) return Status(StatusCode::NotFound, "there is no world to keep a take of");
    if (session.player) return session.openBytes();
    std::vector<std::uint8_t> bytes = session.log.bytes(*session.world);
    if (session.recorded) append(bytes, TakeEncoder::about(session.recordedAbout));
    return bytes;
}

std::vector<std::uint8_t> Session::Impl::openBytes() const {
    std::vector<std::uint8_t> bytes = takenBytes;
    if (!(player->about() == player->take().about)) append(bytes, TakeEncoder::about(player->about()));
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

std::string Session::openTakeName() const {
    return impl_->player ? impl_->player->fileName() : std::string();
}

std::string Session::recordedTakeName() const {
    return impl_->log.fileName();
}

void Session::takeEdited(const std::string& fileName, const TakeAbout& about) {
    if (!impl_->player || fileName.empty() || impl_->player->fileName() != fileName) return;
    TakeAbout edited = about;
    edited.camera = impl_->player->about().camera;
    impl_->player->edit(edited, impl_->player->loops());
    impl_->touchTake();
}

void Session::finish() {
    impl_->stopRecording();
}

// ---- Recording ----

void Session::Impl::setRecording(bool on, SessionClient* client) {
    if (!on) return stopRecording();
    if (recordedFrom >= 0.0) return;
    beginRecording(world->stepCount(), {}, client);
}

void Session::Impl::beginRecording(std::uint32_t from, const std::string& title, SessionClient* client) {
    recordedAbout = {};
    recordedAbout.title = title;
    recordedAbout.from = std::min(from, world->stepCount());
    recordedFrom = recordedAbout.from * world->parameters().stepTime;
    beginFile(client);
}

void Session::Impl::beginFile(SessionClient* client) {
    recorded = true;
    recordedCommands = log.commands();
    log.storeFrames(true);
    touchState();
    if (!def.openSink) return;
    auto sink = def.openSink(name);
    const Status status = sink.ok() ? log.attach(std::move(sink).value(), recordedAbout) : sink.status();
    if (status.ok() || client == nullptr) return;
    notice(*client, protocol::NoticeLevel::Warning, "record",
           "Recording in memory only: " + status.message() + ".");
}

// With `dropEmpty` a moment's recording in which nobody did anything is not kept.
void Session::Impl::stopRecording(bool dropEmpty) {
    const bool ran = recordedFrom >= 0.0;
    const double seconds = ran ? world->time() - recordedFrom : 0.0;
    recordedFrom = -1.0;
    touchState();
    reportLostFile();
    if (!world || !ran) return;
    const bool empty = world->stepCount() <= recordedAbout.from ||
                       (dropEmpty && seconds < kMoment && log.commands() == recordedCommands);
    recordedAbout.to = empty ? kTakeEnd : world->stepCount();
    protocol::TakeKept kept{log.fileName(), seconds, worldDef.name};
    if (log.attached()) {
        const Status status = empty ? log.discard() : log.detach(*world, recordedAbout);
        if (!status.ok()) noticeAll(protocol::NoticeLevel::Warning, "record", status.message());
        if (!status.ok()) kept.name.clear();
    }
    log.storeFrames(false);
    if (empty) return;
    for (auto& [id, to] : clients)
        if (to.greeted) to.outbox.push_back(protocol::encode(kept));
}

// Reports once that the file cannot be written; the log in memory continues.
void Session::Impl::reportLostFile() {
    const Status status = log.takeFailure();
    if (status.ok()) return;
    noticeAll(protocol::NoticeLevel::Warning, "record",
              "Recording in memory only: " + status.message() + ".");
}

// ---- Replays ----

void Session::Impl::stepReplay() {
    if (player->atEnd(*world)) return replayEnded();
    const Status same = player->step(*world, [this] { stepped(); });
    if (same.ok()) player->keep(*world, motion);
    noticeEvents();
    queueEvents();
    if (sceneSignature(*world) != signature) refreshScene();
    if (!same.ok())
        replayFailed(same);
    else if (player->atEnd(*world) && !player->loops())  // Who loops shows the last state, too.
        replayEnded();
}

// What differs only later is shown from the stored frames, too.
void Session::Impl::replayFailed(const Status& status) {
    if (!player->take().frames.empty()) return showStoredFrames();
    player->stay();
    playing = false;
    touchState();
    noticeAll(protocol::NoticeLevel::Error, "replay",
              "The replay differs from the take: " + status.message() +
                  ". It was recorded by another version of Muster and holds no stored frames");
}

void Session::Impl::showStoredFrames() {
    const bool played = playing;
    const std::uint32_t step = player->seeking() ? player->wanted() : world->stepCount();
    const TakeAbout about = player->about();
    const bool loops = player->loops();
    auto shown = TakePlayer::storedFrames(player->shared(), player->fileName());
    shown->edit(about, loops);
    const std::vector<std::uint8_t> bytes = takenBytes;
    if (!begin(name, worldDef, std::move(shown)).ok()) return;
    takenBytes = bytes;
    showEdits(about.edits);
    playing = played;
    player->want(step);
}

void Session::Impl::replayEnded() {
    if (player->loops()) return player->want(player->first());
    playing = false;
    touchState();
    if (endSaid) return;
    endSaid = true;
    const bool whole = player->last() == player->steps();
    std::string words = "The take ends here.";
    if (player->stored())
        words = "The take ends here; it was shown from its stored frames.";
    else if (whole && !player->take().marks.empty())
        words = "The take ends here. It went as it was recorded.";
    if (const std::uint32_t steps = player->unmarked(); steps > 0 && whole)
        words += " Its recording was cut off: the last " + std::to_string(steps) +
                 " steps could not be checked.";
    noticeAll(protocol::NoticeLevel::Info, "replay-end", words);
}

// Goes towards the wanted moment: by a snapshot, then by steps that no client sees.
void Session::Impl::seek() {
    if (player->jump(*world, motion)) {
        frames.restart();
        for (auto& [id, client] : clients) {
            client.events.clear();
            client.frames.restart();
        }
        // The first moment has no step before it.
        if (player->edited() && world->stepCount() == 0) motion.startAgain(), observeMotion();
    }
    for (int i = 0; i < kStepsPerSeek && !player->reached(*world); ++i) {
        const Status same = player->step(*world, [this] { stepped(); });
        if (!same.ok()) return replayFailed(same);
        player->keep(*world, motion);
    }
    (void)player->reached(*world);
    pacer.reset();
    touchState();
    if (sceneSignature(*world) != signature) refreshScene();
}

bool Session::preparing() const {
    const TakePlayer* const player = impl_->player.get();
    return player != nullptr && (player->preparing() || player->gathering()) && !player->seeking();
}

void Session::prepare() {
    if (preparing()) {
        const bool reading = impl_->player->preparing();
        if (impl_->player->prepare(impl_->motion)) impl_->player->showAgain(*impl_->world);
        // Now it is known what is wrong with edits.
        if (reading && !impl_->player->preparing() && !impl_->player->about().edits.empty())
            impl_->touchEdits();
    }
    if (impl_->player && impl_->player->marked()) impl_->keepChanged();
}

Status Session::Impl::editTake(const protocol::EditTake& message) {
    if (!player) return {StatusCode::Unsupported, "no take is open"};
    TakeAbout about;
    about.edits = player->about().edits;
    about.title = message.title;
    about.from = message.from;
    about.to = message.to >= player->steps() ? kTakeEnd : message.to;
    for (const protocol::SpeedPiece& piece : message.speeds)
        about.speeds.push_back({piece.from, piece.to, piece.speed, piece.ease});
    for (const protocol::CameraKey& key : message.camera)
        about.camera.push_back({key.step, key.x, key.y, key.distance, key.turn, key.pitch, key.cut});
    if (Status s = about.check(); !s.ok()) return s;
    const bool changed = !(about == player->about());
    player->edit(about, message.loop);
    touchTake();
    if (!changed || player->fileName().empty() || !def.keepAbout) return {};
    return def.keepAbout(player->fileName(), about);
}

void Session::Impl::sendTake(SessionClient& client) {
    if (client.sentTake != takeRevision) {
        if (player) {
            protocol::TakeState message = player->state();
            if (beneath) message.beneath = beneath->def.name;
            client.outbox.push_back(protocol::encode(message));
        }
        if (!player && client.sentTake != 0) client.outbox.push_back(protocol::encode(protocol::TakeState{}));
        client.sentTake = takeRevision;
        client.sentReady = 0;
    }
    sendPath(client);
    sendTracks(client);
    if (!player || client.sentReady == player->ready() || realTime < client.readyDue) return;
    client.sentReady = player->ready();
    client.readyDue = realTime + kReadySpacing;
    client.outbox.push_back(protocol::encode(protocol::TakeReady{client.sentReady}));
}

// ---- Directing again ----

// The world goes on live from the present moment. A new take holds what the open one held up to here.
Status Session::Impl::takeAgain(bool keep, SessionClient& client) {
    if (!player) return {StatusCode::Unsupported, "no take is open; open one to direct it again"};
    if (player->stored()) return {StatusCode::Unsupported, kFromFrames};
    while (player->seeking()) seek();
    const std::unique_ptr<TakePlayer> taken = std::move(player);
    const Take& take = taken->take();
    const std::uint32_t now = world->stepCount();
    const std::size_t submitted = taken->cursor().command;
    touchTake();
    beneath.reset();
    log.resume(take, now, submitted, !keep, def.limits.takeBytes);
    fullReported = false;
    takenBytes.clear();
    layer.clear();
    nextOfLayer = 0;
    if (keep) {
        layer.assign(take.commands.begin() + static_cast<std::ptrdiff_t>(submitted), take.commands.end());
        std::stable_sort(layer.begin(), layer.end(),
                         [](const Command& a, const Command& b) { return a.step < b.step; });
    } else {
        (void)dropWaitingCommands(*world);
        liftRecorded(take, now);
    }
    renumberClients(take);
    beginRecording(taken->about().firstStep(taken->steps()), titleAgain(*taken), &client);
    playing = false;
    shared.pausedBy = 0;
    shared.touch();
    waitsForHand = true;
    pacer.reset();
    refreshScene();
    noticeAll(protocol::NoticeLevel::Info, "take-again",
              keep ? "Direct on top: it goes on as soon as you touch the crowd, or press Play."
                   : "Direct from here: it goes on as soon as you touch the crowd, or press Play.");
    return {};
}

std::string Session::Impl::titleAgain(const TakePlayer& taken) const {
    const std::string& title = taken.about().title;
    return nextTitle(title.empty() ? worldDef.name : title,
                     def.takeTitles ? def.takeTitles() : std::vector<std::string>());
}

// Recorded commands keep their numbers, so whoever steers now gets higher ones.
void Session::Impl::renumberClients(const Take& take) {
    editor.forgetAll();
    for (const Command& command : take.commands) lastClient = std::max(lastClient, command.client);
    forgetClients();
    for (auto& [id, client] : clients) {
        const std::string called = client.greeted ? directors.name(client.number) : std::string();
        if (client.greeted) directors.leave(client.number);
        client.number = ++lastClient;
        client.scheme.restart(client.number);
        if (client.greeted) greet(client, called);
    }
}

void Session::Impl::liftRecorded(const Take& take, std::uint32_t step, std::uint32_t after) {
    std::map<std::uint32_t, std::uint32_t> sequences;
    for (const Command& command : take.commands) {
        if (command.step >= step || command.client <= after) continue;
        std::uint32_t& last = sequences[command.client];
        last = std::max(last, command.sequence);
    }
    for (const auto& [number, sequence] : sequences) {
        const Command command{step, number, sequence + 1, ReleaseClient{}};
        if (world->submit(command).ok()) log.command(command);
    }
}

// Recorded commands beneath the live ones are submitted in their step.
void Session::Impl::submitLayer() {
    for (; nextOfLayer < layer.size() && layer[nextOfLayer].step <= world->stepCount(); ++nextOfLayer)
        if (world->submit(layer[nextOfLayer]).ok()) log.command(layer[nextOfLayer]);
}

}  // namespace muster
