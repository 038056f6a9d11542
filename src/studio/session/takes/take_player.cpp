#include "studio/session/takes/take_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {
namespace {

constexpr std::size_t kMomentBytes = std::size_t{384} << 20;  // Memory of all snapshots.

std::uint32_t stepsPerSecond(const Take& take) {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(1.0 / take.def.parameters.stepTime)));
}

}  // namespace

TakePlayer::TakePlayer(std::shared_ptr<Take> take, std::string fileName)
    : take_(std::move(take)),
      fileName_(std::move(fileName)),
      about_(take_->about),
      replayer_(*take_),
      moments_(stepsPerSecond(*take_), kMomentBytes),
      paths_(*take_),
      news_(*take_),
      edits_(*take_, false),
      marks_(takeMarks(*take_)) {}

std::unique_ptr<TakePlayer> TakePlayer::marking(std::shared_ptr<Take> take) {
    take->frames.clear();
    auto player = std::make_unique<TakePlayer>(std::move(take), "");
    player->marking_ = true;
    player->replayer_ = Replayer::marking(*player->take_);
    return player;
}

std::unique_ptr<TakePlayer> TakePlayer::storedFrames(std::shared_ptr<Take> take, std::string fileName) {
    auto player = std::make_unique<TakePlayer>(std::move(take), std::move(fileName));
    player->stored_ = true;
    player->edits_ = PlayerEdits(*player->take_, true);
    player->replayer_ = Replayer::stored(*player->take_);
    return player;
}

// One that has read nothing yet.
Replayer TakePlayer::replayer() {
    if (stored_) return Replayer::stored(*take_);
    return marking_ ? Replayer::marking(*take_) : Replayer(*take_);
}

void TakePlayer::kept(std::string fileName) {
    marking_ = false;
    fileName_ = std::move(fileName);
    // From now on the hashes are compared.
    const Replayer::Cursor cursor = replayer_.cursor();
    replayer_ = Replayer(*take_);
    replayer_.goTo(cursor);
}

void TakePlayer::edit(TakeAbout about, bool loop) {
    about.edits = std::move(about_.edits);
    about_ = std::move(about);
    loop_ = loop;
}

void TakePlayer::setEdits(std::vector<TakeEdit> edits, const ClipLibrary& library) {
    about_.edits = std::move(edits);
    edits_.set(about_.edits, library);
}

void TakePlayer::showAgain(const World& world) {
    if (!wanted_) wanted_ = world.stepCount();
    stale_ = true;
}

Status TakePlayer::step(World& world, const std::function<void()>& stepped) {
    Status status = replayer_.submit(world);
    world.step();
    paths_.observe(world);
    news_.observe(world);
    stepped();
    if (status.ok()) status = replayer_.compare(world);
    return status;
}

void TakePlayer::keep(const World& world, const MotionFrames& motion) {
    if (!moments_.missing(world.stepCount())) return;
    moments_.keep(world.stepCount(), {world.snapshot(), motion.motion().state(), replayer_.cursor()});
}

bool TakePlayer::jump(World& world, MotionFrames& motion) {
    if (!wanted_) return false;
    // Edited people begin to move again with the step after a snapshot, which may hold how they moved before.
    const auto* best = moments_.before(edited() && *wanted_ > 0 ? *wanted_ - 1 : *wanted_);
    const std::uint32_t now = world.stepCount();
    const bool stale = std::exchange(stale_, false);
    if (best == nullptr || (!stale && now <= *wanted_ && now >= best->first)) return false;
    if (!world.rewind(best->second.world).ok()) return false;
    motion.goBack(*best->second.motion);
    motion.forget(edits_.touched());
    replayer_.goTo(best->second.cursor);
    return true;
}

bool TakePlayer::reached(const World& world) {
    if (!wanted_ || world.stepCount() < *wanted_) return false;
    wanted_.reset();
    return true;
}

void TakePlayer::beginScout(const MotionFrames& motion) {
    auto world = World::create(take_->def, 1);
    if (!world.ok()) {
        scouted_ = true;
        return;
    }
    scout_ = std::make_unique<Scout>(Scout{std::move(world).value(), replayer(),
                                           CrowdMotion(motion.library(), {motion.tracksAll(take_->def)})});
    scout_->motion.update(scout_->world);
}

void TakePlayer::storeFrames(const World& world) {
    const bool last = world.stepCount() >= steps();
    if (!frames_.observe(world) && !last) return;
    for (TakeFrame& frame : frames_.take()) take_->frames.push_back(std::move(frame));
}

bool TakePlayer::prepare(const MotionFrames& motion) {
    if (scouted_) return edits_.gather();
    scout(motion);
    return false;
}

void TakePlayer::scout(const MotionFrames& motion) {
    if (!scout_) beginScout(motion);
    if (!scout_) return;
    Scout& scout = *scout_;
    // Where the shown world is ahead, the scout goes on from its last snapshot.
    const auto* best = marking_ ? nullptr : moments_.before(steps());
    if (best && best->first > scout.world.stepCount()) {
        if (!scout.world.rewind(best->second.world).ok()) scouted_ = true;
        scout.motion.goBack(*best->second.motion);
        scout.replayer.goTo(best->second.cursor);
    }
    if (!scouted_ && !scout.replayer.atEnd(scout.world)) {
        Status status = scout.replayer.submit(scout.world);
        scout.world.step();
        paths_.observe(scout.world);
        news_.observe(scout.world);
        scout.motion.update(scout.world);
        if (status.ok()) status = scout.replayer.compare(scout.world);
        if (marking_) storeFrames(scout.world);
        const std::uint32_t step = scout.world.stepCount();
        if (moments_.missing(step))
            moments_.keep(step, {scout.world.snapshot(), scout.motion.state(), scout.replayer.cursor()});
        // Where it differs, playing tells so.
        if (status.ok() && !scout.replayer.atEnd(scout.world)) return;
    }
    scouted_ = true;
    scout_.reset();
}

protocol::TakeState TakePlayer::state() const {
    protocol::TakeState state;
    state.open = true;
    state.name = fileName_;
    state.title = about_.title;
    state.steps = steps();
    state.stepTime = take_->def.parameters.stepTime;
    state.from = first();
    state.to = last();
    state.loop = loop_;
    state.stored = stored_;
    for (const SpeedPiece& piece : about_.speeds)
        state.speeds.push_back({piece.from, piece.to, piece.speed, piece.ease});
    for (const CameraKey& key : about_.camera)
        state.camera.push_back({key.step, key.x, key.y, key.distance, key.turn, key.pitch, key.cut});
    state.marks = marks_;
    return state;
}

}  // namespace muster
