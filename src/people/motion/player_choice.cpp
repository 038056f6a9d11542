// The player's choice of clips: locomotion by motion matching, jumps and climbs by their patch.
#include <algorithm>
#include <limits>

#include "engine/geometry/polygon.h"
#include "muster/generated/parameters.h"
#include "people/motion/player.h"

namespace muster {
namespace {

constexpr std::uint32_t kSearchPeriod = 6;  // Steps between searches.
constexpr float kClearlyBetter = 1.0f;      // Least gain in cost for a switch to another frame.
constexpr float kGoingSpeed = 0.25f;        // Speed above which standing clips are excluded [m/s].
constexpr float kGoingReach = 0.3f;  // Predicted distance in 1 s above which standing clips are excluded [m].
// Speed below which the character stands if the predicted distance is short [m/s].
constexpr float kStandingSpeed = 0.1f;
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// The default gains of the simulation's steering, so that predictions match it.
constexpr double kVelocityGain = Parameters::Character{}.velocityGain;
constexpr double kAcceleration = Parameters::Character{}.acceleration;
constexpr double kPositionGain = Parameters::Character{}.positionGain;
constexpr double kTurnRate = 8.0;  // Rate of turning [1/s].

float unevenness(std::uint32_t id, std::size_t feature) {
    std::uint32_t h = (id * 31u + static_cast<std::uint32_t>(feature)) * 0x9e3779b9u;
    h = (h ^ (h >> 15)) * 0x85ebca6bu;
    h ^= h >> 13;
    return static_cast<float>(h >> 8) / 8388608.0f - 1.0f;
}

}  // namespace

Trajectory predict(Vec2 velocity, const Rotation& facing, const WalkTarget& target, float size) {
    constexpr int kSteps = 8;  // Number of integration steps per horizon.
    constexpr double dt = 1.0 / 24.0;
    Trajectory trajectory;
    Vec2 moved, v = velocity, face{facing.c, facing.s};
    double time = 0.0;
    for (std::size_t h = 0; h < kHorizons.size(); ++h) {
        for (int s = 0; s < kSteps; ++s) {
            // The place is predicted to move at constant velocity.
            const Vec2 left = target.toPlace + target.placeVelocity * time - moved;
            const Vec2 arrive = clampLength(target.placeVelocity + left * kPositionGain, target.topSpeed);
            const Vec2 preferred = target.arriving ? arrive : target.cruise;
            v += clampLength((preferred - v) * (kVelocityGain * dt), kAcceleration * dt);
            moved += v * dt;
            time += dt;
            if (lengthSquared(v) > 0.0225)
                face = normalized(face + (normalized(v) - face) * (kTurnRate * dt), face);
        }
        const Vec2 at = facing.applyInverse(moved) / static_cast<double>(size),
                   to = facing.applyInverse(face);
        trajectory[2 * h] = static_cast<float>(at.x);
        trajectory[2 * h + 1] = static_cast<float>(at.y);
        trajectory[6 + 2 * h] = static_cast<float>(to.x);
        trajectory[7 + 2 * h] = static_cast<float>(to.y);
    }
    return trajectory;
}

WalkTarget Player::walkTarget(const Step& step) const {
    const Characters& characters = *step.crowd->characters;
    const std::size_t i = step.i;
    WalkTarget target;
    target.topSpeed = step.crowd->maxSpeed *
                      step.crowd->environment->ground(characters.position[i]).travelSpeed;
    target.cruise = characters.direction[i] * target.topSpeed;
    const std::int32_t place = characters.place[i];
    const std::uint32_t group = characters.group[i];
    const auto places = step.crowd->places;
    if (place < 0 || group >= places.size()) return target;
    const auto p = static_cast<std::size_t>(place);
    if (p >= places[group].positions.size()) return target;
    target.toPlace = places[group].positions[p] - characters.position[i];
    target.placeVelocity = places[group].velocities[p];
    target.arriving = length(target.toPlace) < step.crowd->directReach;
    return target;
}

std::optional<MotionSet> Player::motionSet(const Step& step) {
    const std::uint32_t group = step.crowd->characters->group[step.i];
    const auto sets = step.crowd->motionSets;
    return group < sets.size() ? sets[group] : std::nullopt;
}

void Player::playLocomotion(Mover& mover, const Step& step) const {
    const ClipEntry& now = table_[mover.clip];
    const bool over = !now.cyclic && mover.time >= now.duration - 1.0e-4f;
    const bool must = now.use != ClipUse::Locomotion || over || mover.fresh;
    if (must || (searchSlot_ + mover.id) % kSearchPeriod == 0) searchLocomotion(mover, step, must);
    const ClipEntry& entry = table_[mover.clip];
    float wanted = mover.cadence;
    if (!entry.standing && entry.speed > 0.0f) {
        const float clipSpeed = std::max(0.3f, table_.speedAt(mover.clip, mover.time)) * mover.size;
        wanted = std::clamp(step.speed / clipSpeed * mover.cadence, 0.7f, 1.3f);
    }
    mover.rate += (wanted - mover.rate) * std::min(1.0f, static_cast<float>(step.dt) / 0.08f);
    mover.rate = std::clamp(mover.rate, 0.7f, 1.3f);
    advance(mover, step.dt);
}

// The cost of continuing the present clip. The play rate can adapt the speed by 15 %, so that part of the
// difference is free.
float Player::continuationCost(const Mover& mover, Trajectory trajectory, std::int32_t row) const {
    const ClipEntry& entry = table_[mover.clip];
    if (!entry.standing && entry.speed > 0.0f) {
        const auto speed = static_cast<float>(length(mover.velocity)) / mover.size;
        const float slower = 1.0f / std::clamp(speed / std::max(0.3f, table_.speedAt(mover.clip, mover.time)),
                                               0.85f, 1.15f);
        for (std::size_t f = 0; f < 6; ++f) trajectory[f] *= slower;
    }
    return features_.cost(features_.query(trajectory, row), row);
}

void Player::searchLocomotion(Mover& mover, const Step& step, bool must) const {
    const ClipEntry& now = table_[mover.clip];
    if (!must && mover.fade > 0.0f) return;
    Trajectory trajectory = predict(mover.velocity, mover.facing, walkTarget(step), mover.size);
    const float reach = std::sqrt(trajectory[4] * trajectory[4] + trajectory[5] * trajectory[5]);
    const bool going = step.speed > kGoingSpeed || reach > kGoingReach;
    const bool staying = step.speed < kStandingSpeed && reach < 0.5f * kGoingReach;
    // A stop clip near its end is not interrupted.
    if (!must && staying && !now.cyclic && table_.speedAt(mover.clip, mover.time) < 0.5f) return;
    const ClipFilter filter = going ? ClipFilter::Going : staying ? ClipFilter::Standing : ClipFilter::Any;
    const float least = 0.7f * table_.slowest();
    if (going && reach < least) {
        const float longer = least / std::max(reach, 0.05f);
        for (std::size_t f = 0; f < 6; ++f) trajectory[f] *= longer;
    }
    const std::int32_t row = features_.rowOf(mover.clip, mover.time);
    Features sought = features_.query(trajectory, row);
    // A variation by id, so that standing characters do not all start with the same foot.
    if (now.standing)
        for (std::size_t f = kTrajectoryCount; f < kFeatureCount; ++f)
            sought[f] += 0.35f * unevenness(mover.id, f);
    const std::optional<MotionSet> set = motionSet(step);
    const bool unfit = !features_.suits(mover.clip, set) ||
                       (filter != ClipFilter::Any && now.standing != (filter == ClipFilter::Standing));
    const float cost = must || unfit ? kInfinite : continuationCost(mover, trajectory, row);
    if (cost <= kClearlyBetter) return;
    Match match = features_.search(sought, filter, set, cost - kClearlyBetter);
    if (match.row < 0 && must) match = features_.search(sought, ClipFilter::Any, set, kInfinite);
    if (match.row < 0) return;
    const std::size_t clip = features_.clipOf(match.row);
    const float time = features_.timeOf(match.row);
    if (clip == mover.clip && !must && std::fabs(time - mover.time) < 0.1f) return;
    show(mover, clip, time);
}

void Player::startAction(Mover& mover, const Step& step) const {
    const Characters& characters = *step.crowd->characters;
    const Motion& motion = motions_[characters.motion[step.i]];
    const std::uint32_t patch = characters.patch[step.i];
    if (motion.use != ClipUse::Action || patch == 0) return;
    const PatchDef* def = step.crowd->environment->patch(PatchId{patch});
    const bool moves = def != nullptr && !def->path.still();
    const std::int32_t clip = moves ? motion.movingClip : motion.clip;
    if (clip < 0) return;
    mover.action = crossPatch(*step.crowd->environment, patch, mover.position, characters.heading[step.i],
                              static_cast<double>(table_[clip].length));
    mover.action.clip = clip;
}

void Player::endAction(Mover& mover) {
    mover.donePatch = mover.action.patch;
    mover.action = {};
}

// The play rate over a moving patch at which the clip is at its middle when the patch is nearest.
float Player::leapRate(const Mover& mover, const Step& step, float middle) const {
    const Environment& environment = *step.crowd->environment;
    const PatchDef* patch = environment.patch(PatchId{mover.action.patch});
    if (patch == nullptr || mover.time >= middle) return 1.0f;
    const Vec2 centre = centroid(patch->polygon) + patch->path.at(environment.time()).position;
    const Vec2 nearing = mover.velocity - patch->path.velocity(environment.time());
    const double left = dot(centre - mover.position, nearing) / std::max(0.01, lengthSquared(nearing));
    return std::clamp((middle - mover.time) / std::max(0.05f, static_cast<float>(left)), 0.8f, 1.3f);
}

bool Player::playAction(Mover& mover, const Step& step) {
    PatchCrossing& action = mover.action;
    if (action.patch == 0 && needsAction(mover, step)) startAction(mover, step);
    if (action.patch == 0) return false;
    const bool locked = step.crowd->characters->phase[step.i] == MotionPhase::Locked;
    const double share = action.timed ? 0.0 : shareCrossed(action, mover.position);
    if (!locked && share < 0.15 && !action.timed) {  // The character turned back before the action.
        endAction(mover);
        return false;
    }
    if (share < 0.0) return false;
    const auto clip = static_cast<std::size_t>(action.clip);
    if (mover.clip != action.clip) show(mover, clip, 0.0f);
    if (action.timed) {
        mover.rate = leapRate(mover, step, travelTimes_[clip].time(0.5f));
    } else {
        // A clip does not stop in the air, nor after the character has left the patch.
        const float least = !locked ? 0.8f : airborne(clip, mover.time) ? 0.7f : 0.0f;
        const float due = travelTimes_[clip].time(static_cast<float>(share)) - mover.time;
        mover.rate = std::clamp(due / static_cast<float>(step.dt), least, 1.5f);
    }
    advance(mover, step.dt);
    if (mover.time >= table_[clip].duration - 1.0e-4f) endAction(mover);
    return true;
}

// True in a single-step patch that is not the one just completed.
bool Player::needsAction(Mover& mover, const Step& step) {
    const Characters& characters = *step.crowd->characters;
    if (characters.lastSingle[step.i] == 0) mover.donePatch = 0;
    if (characters.phase[step.i] != MotionPhase::Locked) return false;
    if (mover.donePatch == 0) return true;
    const PatchId patch{characters.patch[step.i]}, done{mover.donePatch};
    return patch.value != done.value && !step.crowd->environment->onePatch(patch, done);
}

bool Player::airborne(std::size_t clip, float time) const {
    for (std::size_t limb = 0; limb < kLockableLimbCount; ++limb)
        if (table_.contactAt(clip, limb, time) != nullptr) return false;
    return true;
}

}  // namespace muster
