#include "people/motion/player.h"

#include <algorithm>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kVelocityTime = 0.06;  // Smoothing time of velocities [s].
constexpr float kFadeTime = 0.2f;       // Duration of cross-fades [s].
constexpr float kStrideTime = 0.05f;    // Smoothing time of the lengths of steps [s].

float share(std::uint32_t id, std::uint32_t salt) {
    std::uint32_t h = id * 0x9e3779b9u + salt;
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    h ^= h >> 16;
    return static_cast<float>(h >> 8) / 16777216.0f;
}

float wrappedTime(const ClipEntry& entry, float time) {
    if (!entry.cyclic) return std::clamp(time, 0.0f, entry.duration);
    while (time >= entry.duration) time -= entry.duration;
    return time < 0.0f ? 0.0f : time;
}

}  // namespace

Player::Player(const ClipTable& table) : table_(table), features_(table) {
    for (std::size_t c = 0; c < table.size(); ++c) travelTimes_.emplace_back(*table[c].clip);
}

void Player::restart() {
    movers_.clear();
    motions_.clear();
    motionNames_.clear();
    searchSlot_ = 0;
}

void Player::learnMotions(const Environment& environment) {
    const std::vector<ClipFacts>& facts = environment.def().clips;
    bool same = facts.size() == motionNames_.size();
    for (std::size_t m = 0; same && m < facts.size(); ++m) same = facts[m].name == motionNames_[m];
    if (same) return;
    motions_.clear();
    motionNames_.clear();
    for (const ClipFacts& fact : facts) {
        Motion motion;
        motion.clip = table_.find(fact.name);
        motion.transition = fact.transitionTime;
        motion.movingClip = motion.clip;
        if (fact.name == "jump" && table_.find("jump-over") >= 0) motion.clip = table_.find("jump-over");
        if (motion.clip >= 0) motion.use = table_[motion.clip].use;
        motions_.push_back(motion);
        motionNames_.push_back(fact.name);
    }
}

void Player::begin(Mover& mover, const Characters& characters, std::size_t i) const {
    mover = Mover{};
    mover.id = characters.id[i];
    mover.position = characters.position[i];
    mover.velocity = characters.velocity[i];
    mover.size = characterSize(mover.id);
    mover.cadence = 0.95f + 0.1f * share(mover.id, 1);
    if (table_.idle() < 0) return;
    mover.clip = mover.fromClip = static_cast<std::uint16_t>(table_.idle());
    mover.time = mover.fromTime = share(mover.id, 2) * table_[mover.clip].duration;
}

// Characters and movers are in order of ids, so one merge drops removed characters and starts new ones.
void Player::matchMovers(const Characters& characters) {
    bool same = movers_.size() == characters.size();
    for (std::size_t i = 0; same && i < movers_.size(); ++i) same = movers_[i].id == characters.id[i];
    if (same) return;
    spare_.clear();
    std::size_t old = 0;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        while (old < movers_.size() && movers_[old].id < characters.id[i]) ++old;
        Mover& mover = spare_.emplace_back();
        if (old < movers_.size() && movers_[old].id == characters.id[i])
            mover = movers_[old];
        else
            begin(mover, characters, i);
    }
    movers_.swap(spare_);
}

void Player::follow(Mover& mover, const Characters& characters, std::size_t i, double dt) const {
    const Vec2 moved = characters.position[i] - mover.position;
    if (mover.again || lengthSquared(moved) > kPutElsewhere * kPutElsewhere)
        begin(mover, characters, i);
    else
        mover.velocity += (moved / dt - mover.velocity) * std::min(1.0, dt / kVelocityTime);
    mover.position = characters.position[i];
    mover.switched = false;
}

void Player::forget(std::span<const std::uint32_t> ids) {
    for (Mover& mover : movers_)
        if (std::binary_search(ids.begin(), ids.end(), mover.id)) mover.again = true;
}

void Player::update(const CrowdView& crowd) {
    const Characters& characters = *crowd.characters;
    learnMotions(*crowd.environment);
    for (Mover& mover : movers_) mover.fresh = false;
    matchMovers(characters);
    const double dt = crowd.stepTime;
    ++searchSlot_;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
        Mover& mover = movers_[i];
        follow(mover, characters, i, dt);
        const Step step{&crowd, i, dt, static_cast<float>(length(mover.velocity))};
        turnToCrossing(mover, step);
        play(mover, step);
        setStride(mover, step);
    }
}

void Player::show(Mover& mover, std::size_t clip, float time) const {
    mover.fromClip = mover.clip;
    mover.fromTime = mover.time;
    mover.fade = mover.fresh ? 0.0f : 1.0f;
    mover.clip = static_cast<std::uint16_t>(clip);
    mover.time = wrappedTime(table_[clip], time);
    mover.switched = !mover.fresh;
}

void Player::advance(Mover& mover, double dt) const {
    const auto by = mover.rate * static_cast<float>(dt);
    mover.time = wrappedTime(table_[mover.clip], mover.time + by);
    mover.fromTime = wrappedTime(table_[mover.fromClip], mover.fromTime + by);
    mover.fade = std::max(0.0f, mover.fade - static_cast<float>(dt) / kFadeTime);
}

void Player::play(Mover& mover, const Step& step) {
    const Characters& characters = *step.crowd->characters;
    const Motion& motion = motions_[characters.motion[step.i]];
    if (playAction(mover, step)) return;
    if (motion.use != ClipUse::Cycle && playChosen(mover, step)) return;
    if (motion.clip < 0 || motion.use != ClipUse::Cycle) return playLocomotion(mover, step);
    const ClipEntry& cycle = table_[motion.clip];
    switch (characters.phase[step.i]) {
        case MotionPhase::Entering:
            if (cycle.enter >= 0) return playTransition(mover, step, cycle.enter, motion.transition);
            return playCycle(mover, step, motion.clip);
        case MotionPhase::Leaving:
            if (cycle.exit >= 0) return playTransition(mover, step, cycle.exit, motion.transition);
            return playLocomotion(mover, step);
        default:
            return playCycle(mover, step, motion.clip);
    }
}

// A clip that does not repeat is played once; then the character moves as usual.
bool Player::playChosen(Mover& mover, const Step& step) const {
    const auto clips = step.crowd->chosenClips;
    const std::int32_t chosen = step.i < clips.size() ? clips[step.i] : -1;
    if (chosen != mover.chosen) {
        mover.chosen = chosen;
        mover.chosenOver = false;
        if (chosen >= 0 && mover.clip != chosen) show(mover, static_cast<std::size_t>(chosen), 0.0f);
    }
    if (chosen < 0 || mover.chosenOver) return false;
    const ClipEntry& entry = table_[chosen];
    if (mover.clip != chosen) show(mover, static_cast<std::size_t>(chosen), 0.0f);
    float wanted = 1.0f;
    if (entry.cyclic && !entry.standing && entry.speed > 0.0f)
        wanted = std::clamp(step.speed / (entry.speed * mover.size) * mover.cadence, 0.7f, 1.3f);
    mover.rate += (wanted - mover.rate) * std::min(1.0f, static_cast<float>(step.dt) / 0.08f);
    advance(mover, step.dt);
    mover.chosenOver = !entry.cyclic && mover.time >= entry.duration - 1.0e-4f;
    return true;
}

void Player::playTransition(Mover& mover, const Step& step, std::int32_t clip, double transition) const {
    const ClipEntry& entry = table_[clip];
    const double share = transition > 0.0 ? step.crowd->characters->motionTime[step.i] / transition : 1.0;
    if (mover.clip != clip) show(mover, static_cast<std::size_t>(clip), 0.0f);
    mover.rate = transition > 0.0 ? entry.duration / static_cast<float>(transition) : 1.0f;
    advance(mover, step.dt);
    mover.time = entry.duration * static_cast<float>(std::min(1.0, share));
}

void Player::playCycle(Mover& mover, const Step& step, std::int32_t clip) const {
    const ClipEntry& entry = table_[clip];
    if (mover.clip != clip) {
        const bool entered = mover.clip == entry.enter;
        const std::int32_t row = entered ? -1
                                         : features_.nearestPose(static_cast<std::size_t>(clip),
                                                                 features_.rowOf(mover.clip, mover.time));
        const float time = entered ? static_cast<float>(table_[mover.clip].clip->entryPhase) * entry.duration
                                   : features_.timeOf(row);
        show(mover, static_cast<std::size_t>(clip), time);
    }
    const float raw = entry.speed > 0.0f ? step.speed / (entry.speed * mover.size) : 1.0f;
    float wanted = std::min(raw, 1.5f);  // A crawler follows the speed by its play rate alone.
    if (!entry.feetTouch)
        wanted = std::clamp(raw * mover.cadence, 0.5f, 1.5f);  // Swimmers tread water when they stop.
    else if (!entry.handsTouch)
        wanted = std::clamp(raw * mover.cadence, 0.7f, 1.3f) * std::min(1.0f, step.speed / 0.15f);
    mover.rate += (wanted - mover.rate) * std::min(1.0f, static_cast<float>(step.dt) / 0.08f);
    advance(mover, step.dt);
}

void Player::turnToCrossing(Mover& mover, const Step& step) const {
    constexpr double kMost = 20.0 / 180.0 * kPi;
    const Vec2 heading = step.crowd->characters->heading[step.i];
    double wanted = 0.0;
    if (mover.action.patch != 0 && !mover.action.timed)
        wanted = std::clamp(
            arcTangent2(cross(heading, mover.action.normal), dot(heading, mover.action.normal)), -kMost,
            kMost);
    mover.shift += (static_cast<float>(wanted) - mover.shift) *
                   std::min(1.0f, static_cast<float>(step.dt) / 0.12f);
    const double yaw = arcTangent2(heading.y, heading.x) + static_cast<double>(mover.shift);
    mover.yaw = static_cast<float>(yaw);
    mover.facing = mover.shift == 0.0f ? Rotation{heading.x, heading.y} : Rotation{cosine(yaw), sine(yaw)};
}

// Scales and rotates steps so that standing feet match the velocity of the body.
void Player::setStride(Mover& mover, const Step& step) const {
    const ClipEntry& entry = table_[mover.clip];
    Vec2 way{1.0, 0.0};
    float stride = 1.0f;
    if (entry.use == ClipUse::Action && !mover.action.timed && mover.action.patch != 0) {
        stride = static_cast<float>(mover.action.length) / (std::max(0.1f, entry.length) * mover.size);
    } else if (entry.strides) {
        const float clipSpeed = std::max(0.3f, table_.speedAt(mover.clip, mover.time)) * mover.size *
                                std::max(0.3f, mover.rate);
        const bool leaps = entry.use == ClipUse::Action;  // Jumps and climbs allow little stretching.
        stride = std::clamp(step.speed / clipSpeed, leaps ? 0.7f : 0.0f, leaps ? 1.15f : 1.6f);
        if (!leaps) way = normalized(mover.facing.applyInverse(mover.velocity) + Vec2{0.05, 0.0}, {1.0, 0.0});
    }
    const Vec2 go = way * static_cast<double>(stride);
    const float share = mover.fresh ? 1.0f : std::min(1.0f, static_cast<float>(step.dt) / kStrideTime);
    mover.strideX += (static_cast<float>(go.x) - mover.strideX) * share;
    mover.strideY += (static_cast<float>(go.y) - mover.strideY) * share;
}

}  // namespace muster
