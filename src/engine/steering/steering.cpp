#include "engine/steering/steering.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// A character within a single-step motion deviates at most 20 degrees from its heading (cosine and sine).
constexpr Rotation kLockedDeviation{0.93969262078590838405, 0.34202014332566873304};
constexpr double kLockEnd = 0.6;        // Within this distance of its place the heading is not locked [m].
constexpr double kHeadingRate = 8.0;    // Gain of the heading [1/s].
constexpr double kLyingRate = 2.0;      // Gain of the heading of who leans or lies [1/s].
constexpr double kTouchGap = 0.04;      // Two bodies with a smaller gap touch [m].
constexpr double kBlockedSpeed = 0.15;  // A slower character that touches another is blocked [m/s].
constexpr double kAheadCosine = 0.5;    // Twice the cosine below which two characters are side by side.
constexpr double kYieldSpeed = 0.3;     // At which a character steps back from a blocked one [m/s].
constexpr float kStandsFor = 3.0f;      // Two who have stood and touched for so long bar each other [s].
constexpr float kStepBack = 4.0f;       // Then they take turns of this length in stepping back [s].
constexpr double kBrakes = 0.8;         // Share of its acceleration with which a character brakes.
constexpr std::size_t kSteeredPerTask = 256;  // Characters per task.
constexpr double kWalkingInCrowd = 0.05;      // A slower character does not walk along with others [m/s].
constexpr double kWalkingSpeed = 0.15;        // A slower character stands and faces with the formation [m/s].

// The direction, or the nearest one that a locked heading allows.
Vec2 limitDeviation(Vec2 direction, Vec2 heading) {
    if (dot(direction, heading) >= kLockedDeviation.c) return direction;
    return cross(heading, direction) >= 0.0 ? kLockedDeviation.apply(heading)
                                            : kLockedDeviation.applyInverse(heading);
}

Vec2 rotateTowards(Vec2 heading, Vec2 towards, double share) {
    // Between opposite headings the interpolation is undefined: rotate to the left.
    if (dot(heading, towards) < -0.999) towards = perpendicular(heading);
    return normalized(heading + (towards - heading) * share, heading);
}

// True where both walk, at less than a right angle to each other.
bool walkTogether(Vec2 a, Vec2 b) {
    constexpr double kLeast = kWalkingInCrowd * kWalkingInCrowd;
    return dot(a, b) > 0.0 && lengthSquared(a) > kLeast && lengthSquared(b) > kLeast;
}

// How far `a` is ahead of `b` in the mean direction of both; 0 where they are side by side.
double lead(const Characters& now, std::int32_t a, std::int32_t b) {
    const Vec2 apart = now.position[a] - now.position[b];
    const double along = dot(apart, now.direction[a] + now.direction[b]);
    return std::fabs(along) > kAheadCosine * length(apart) ? along : 0.0;
}

// Of two side by side, the one with the lower cost to its place counts as ahead.
bool isAhead(const Characters& now, std::int32_t a, std::int32_t b) {
    const double along = lead(now, a, b);
    if (along != 0.0) return along > 0.0;
    return now.cost[a] != now.cost[b] ? now.cost[a] < now.cost[b] : a < b;
}

// True where both have stood for a while, and not in the queue of a passage.
bool bothStand(const Characters& now, std::span<const PlaceWait> waits, std::int32_t a, std::int32_t b) {
    const auto queues = [&](std::int32_t i) { return !now.chosen.empty() && now.chosen[i].way >= 0; };
    return !waits.empty() && std::min(waits[a].stood, waits[b].stood) > kStandsFor && !queues(a) &&
           !queues(b);
}

// Of two who both stand, the other one steps back every few seconds: the first may have a wall behind it.
// Side by side they take turns, else the one ahead has the third of four.
bool takesTurn(const Characters& now, std::span<const PlaceWait> waits, std::int32_t a, std::int32_t b) {
    const auto turn = static_cast<std::int32_t>(std::min(waits[a].stood, waits[b].stood) / kStepBack);
    return lead(now, a, b) == 0.0 ? turn % 2 == 1 : turn % 4 == 2;
}

// The velocity towards the place: along the planned path, or straight where the place is near.
Vec2 preferredVelocity(const Parameters::Character& def, const Characters& now, const SteeringInput& input,
                       std::size_t i, double topSpeed, double brakes) {
    const Vec2 direction = now.direction[i];
    const bool placed = now.place[i] >= 0;
    if (!placed && direction == Vec2{}) return {};
    const Vec2 toPlace = input.place[i] - now.position[i];
    const double left = length(toPlace);
    const bool crossing = now.phase[i] == MotionPhase::Locked && left > kLockEnd &&
                          lengthSquared(now.velocity[i]) > 0.01;
    if (crossing) return limitDeviation(direction, now.heading[i]) * topSpeed;
    if (placed && left < 1e-6) return clampLength(input.placeVelocity[i], topSpeed);
    // It comes to the speed of its place by its own brakes.
    const double closing = std::sqrt(2.0 * kBrakes * brakes * left);
    if (placed && left < def.directReach && dot(direction, toPlace) > 0.999 * left)
        return clampLength(input.placeVelocity[i] + toPlace * std::min(def.positionGain, closing / left),
                           topSpeed);
    const double along = placed ? std::max(0.0, dot(input.placeVelocity[i], direction)) : topSpeed;
    return direction * std::min(topSpeed, along + closing);
}

// Gains for one time step, the same for all characters.
struct StepGains {
    double velocityShare;  // Share of the velocity error that is corrected.
    double headingShare;   // Share of the heading error that is corrected.
    double lyingShare;     // The same for who leans or lies.
};

// `most` bounds the change of velocity [m/s].
Vec2 nextVelocity(double share, double most, Vec2 velocity, Vec2 preferred, double topSpeed) {
    const Vec2 desired = clampLength(preferred, topSpeed);
    const Vec2 change = clampLength((desired - velocity) * share, most);
    return clampLength(velocity + change, topSpeed);
}

}  // namespace

// Separation steering (Reynolds 1987), and a sidestep to the right of two who approach each other. Each takes
// its share of both, by mass.
void Steering::addSeparationSteering(const CrowdBodies& bodies, const Characters& now) {
    const Parameters::Character& def = bodies.usual();
    if (def.separationGain <= 0.0 || def.separationReach <= 0.0) return;
    const auto intent = [&](std::int32_t i) { return bodies.isFixed(i) ? now.velocity[i] : preferred_[i]; };
    for (const NeighbourPair pair : neighbours_.pairs()) {
        const std::int32_t a = pair.low, b = pair.high;
        const double reach = bodies.touching(a, b) + def.separationReach;
        const Vec2 between = now.position[b] - now.position[a];
        if (lengthSquared(between) >= reach * reach || walkTogether(now.velocity[a], now.velocity[b]))
            continue;
        const Vec2 away = normalized(between, {1.0, 0.0});
        const double closeness = (reach - length(between)) / def.separationReach;
        const Vec2 push = away * (def.separationGain * def.separationReach * std::min(1.0, closeness));
        // Both step to their right, so that meeting head on is no tie.
        const double closing = dot(intent(a) - intent(b), away);
        const Vec2 sidestep = closing > 0.0
                                  ? perpendicular(away) * (0.25 * closing * std::min(1.0, closeness))
                                  : Vec2{};
        preferred_[a] -= (push + sidestep) * (2.0 * bodies.share(a, b));
        preferred_[b] += (push + sidestep) * (2.0 * bodies.share(b, a));
    }
}

// Of two who touch and walk in the same direction, the one behind steps back from a blocked one ahead.
// Otherwise crowds would form stable arches before doors. Of two who bar each other side by side, one steps
// back against its own direction.
void Steering::yieldToBlocked(const CrowdBodies& bodies, const Characters& now,
                              std::span<const PlaceWait> waits) {
    for (const NeighbourPair pair : neighbours_.pairs()) {
        const double touching = bodies.touching(pair.low, pair.high) + kTouchGap;
        std::int32_t front = pair.low, back = pair.high;
        if (isAhead(now, back, front)) std::swap(front, back);
        const bool standing = bothStand(now, waits, front, back);
        if (standing && takesTurn(now, waits, front, back)) std::swap(front, back);
        const Vec2 between = now.position[front] - now.position[back];
        if (lengthSquared(now.velocity[front]) > kBlockedSpeed * kBlockedSpeed) continue;
        if (lengthSquared(between) > touching * touching ||
            dot(now.direction[front], now.direction[back]) <= 0.0 || bodies.isFirmer(back, front))
            continue;
        if (standing) {
            preferred_[back] = now.direction[back] * -kYieldSpeed;
            continue;
        }
        const Vec2 ahead = normalized(between, {1.0, 0.0});
        const double pressing = dot(preferred_[back], ahead) - std::max(0.0, dot(now.velocity[front], ahead));
        if (pressing > 0.0) preferred_[back] -= ahead * (pressing + kYieldSpeed);
    }
}

void Steering::run(const CrowdBodies& bodies, const Characters& now, const SteeringInput& input,
                   const Environment& environment, double dt, std::span<Vec2> velocity,
                   std::span<Vec2> heading, ThreadPool* pool) {
    const std::size_t count = now.size();
    const Parameters::Character& def = bodies.usual();
    preferred_.resize(count);
    topSpeed_.resize(count);
    const bool patches = !environment.patchIds().empty();
    forChunks(pool, count, kSteeredPerTask, [&](std::size_t i) {
        topSpeed_[i] = patches ? bodies.maxSpeed(i) * environment.ground(now.position[i]).travelSpeed
                               : bodies.maxSpeed(i);
        if (!input.pace.empty()) topSpeed_[i] *= input.pace[i];
        preferred_[i] = preferredVelocity(def, now, input, i, topSpeed_[i], bodies.acceleration(i));
    });
    neighbours_.build(now.position, 2.0 * bodies.largestRadius() + std::max(def.separationReach, kTouchGap));
    bodies.shorten(now.position, neighbours_);
    addSeparationSteering(bodies, now);
    yieldToBlocked(bodies, now, input.waits);
    axes_.resolve(environment, now, input.place, input.placeVelocity);
    axes_.keepDistance(bodies, now, preferred_);
    giveWay_.run(bodies, now, environment, neighbours_, topSpeed_, preferred_);
    const StepGains gains{std::min(1.0, def.velocityGain * dt), std::min(1.0, kHeadingRate * dt),
                          std::min(1.0, kLyingRate * dt)};
    const std::vector<ClipFacts>& clips = environment.def().clips;
    forChunks(pool, count, kSteeredPerTask, [&, gains, patches](std::size_t i) {
        const double turn = patches && clips[now.motion[i]].reachAhead > 0.0 ? gains.lyingShare
                                                                             : gains.headingShare;
        const Vec2 next = bodies.isFixed(i) ? now.velocity[i]
                                            : nextVelocity(gains.velocityShare, bodies.acceleration(i) * dt,
                                                           now.velocity[i], preferred_[i], topSpeed_[i]);
        const double speed = length(next);
        const Vec2 towards = speed > kWalkingSpeed ? next / speed : input.facing[i];
        velocity[i] = next;
        heading[i] = now.phase[i] == MotionPhase::Locked ? now.heading[i]
                                                         : rotateTowards(now.heading[i], towards, turn);
    });
}

}  // namespace muster
