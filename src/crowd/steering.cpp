#include "crowd/steering.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// A locked character turns at most this far from its entry heading (cosine and sine of 20 degrees).
constexpr Rotation kLockTurn{0.93969262078590838405, 0.34202014332566873304};
constexpr double kLockEnds = 0.6;       // Nearer to its place than this nobody is carried on [m].
constexpr double kTurnRate = 8.0;       // Share of the turn made up per second.
constexpr double kTouchGap = 0.04;      // Nearer than this two touch [m].
constexpr double kBlockedSpeed = 0.15;  // Who touches others and is slower is held up [m/s].
// Two are side by side where neither is ahead by this share, twice a cosine.
constexpr double kAhead = 0.5;
constexpr double kGiveWay = 0.3;        // At which one steps back from somebody held up [m/s].
constexpr std::size_t kChunk = 256;     // Characters a task steers.
constexpr double kStandsBelow = 0.05;   // Below it one does not walk on in a crowd [m/s].
constexpr double kWalkingSpeed = 0.15;  // Below it one stands and faces with the formation [m/s].

Vec2 withinLock(Vec2 direction, Vec2 heading) {
    if (dot(direction, heading) >= kLockTurn.c) return direction;
    return cross(heading, direction) >= 0.0 ? kLockTurn.apply(heading) : kLockTurn.applyInverse(heading);
}

Vec2 turned(Vec2 heading, Vec2 towards, double share) {
    // Opposite headings have no middle: turn left.
    if (dot(heading, towards) < -0.999) towards = perpendicular(heading);
    return normalized(heading + (towards - heading) * share, heading);
}

// Whether both walk, and the same way.
bool goTogether(Vec2 a, Vec2 b) {
    constexpr double kLeast = kStandsBelow * kStandsBelow;
    return dot(a, b) > 0.0 && lengthSquared(a) > kLeast && lengthSquared(b) > kLeast;
}

// Whether one of two is ahead along the way of both; side by side the one with the shorter way to go is.
bool isAhead(const Characters& now, std::size_t a, std::size_t b) {
    const Vec2 apart = now.position[a] - now.position[b];
    const double ahead = dot(apart, now.direction[a] + now.direction[b]);
    if (std::fabs(ahead) > kAhead * length(apart)) return ahead > 0.0;
    return now.cost[a] != now.cost[b] ? now.cost[a] < now.cost[b] : a < b;
}

// The velocity that the way and the place alone ask for.
Vec2 preferredVelocity(const SteeringDef& def, const Characters& now, const SteeringInput& input,
                       std::size_t i, double topSpeed) {
    const Vec2 direction = now.direction[i];
    const bool placed = now.place[i] >= 0;
    if (!placed && direction == Vec2{}) return {};
    const Vec2 toPlace = input.place[i] - now.position[i];
    const double left = length(toPlace);
    const bool crossing = now.phase[i] == MotionPhase::Locked && left > kLockEnds &&
                          lengthSquared(now.velocity[i]) > 0.01;
    if (crossing) return withinLock(direction, now.heading[i]) * topSpeed;
    if (placed && left < def.directReach && dot(direction, toPlace) > 0.999 * left)
        return clampLength(input.placeVelocity[i] + toPlace * def.positionGain, topSpeed);
    if (placed && left < 1e-6) return clampLength(input.placeVelocity[i], topSpeed);
    return direction * topSpeed;
}

// What a step may change, the same for all.
struct StepBounds {
    double share;   // Of the way to the wish.
    double change;  // Of velocity [m/s].
    double turn;    // Share of the way to the heading aimed at.
};

Vec2 nextVelocity(const StepBounds& bounds, Vec2 velocity, Vec2 preferred, double topSpeed) {
    const Vec2 wish = clampLength(preferred, topSpeed);
    const Vec2 change = clampLength((wish - velocity) * bounds.share, bounds.change);
    return clampLength(velocity + change, topSpeed);
}

}  // namespace

void Steering::addSidesteps(const SteeringDef& def, const Characters& now) {
    if (def.separationGain <= 0.0 || def.separationReach <= 0.0) return;
    const double reach = 2.0 * def.radius + def.separationReach;
    for (const NearPair pair : pairs_) {
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        const Vec2 between = now.position[b] - now.position[a];
        if (lengthSquared(between) >= reach * reach || goTogether(now.velocity[a], now.velocity[b])) continue;
        const Vec2 away = normalized(between, {1.0, 0.0});
        const double closeness = (reach - length(between)) / def.separationReach;
        const Vec2 push = away * (def.separationGain * def.separationReach * std::min(1.0, closeness));
        // Head on, both give way to their right, so that neither waits for the other.
        const double closing = dot(preferred_[a] - preferred_[b], away);
        const Vec2 aside = closing > 0.0 ? perpendicular(away) * (0.25 * closing * std::min(1.0, closeness))
                                         : Vec2{};
        preferred_[a] -= push + aside;
        preferred_[b] += push + aside;
    }
}

// Two who go the same way and touch: the one behind does not press the other on. Else crowds wedge
// before a door for good, each in the arch held by the rest.
void Steering::holdBack(const SteeringDef& def, const Characters& now) {
    const double touching = 2.0 * def.radius + kTouchGap;
    for (const NearPair pair : pairs_) {
        auto front = static_cast<std::size_t>(pair.a);
        auto back = static_cast<std::size_t>(pair.b);
        if (isAhead(now, back, front)) std::swap(front, back);
        const Vec2 between = now.position[front] - now.position[back];
        if (lengthSquared(now.velocity[front]) > kBlockedSpeed * kBlockedSpeed) continue;
        if (lengthSquared(between) > touching * touching ||
            dot(now.direction[front], now.direction[back]) <= 0.0)
            continue;
        const Vec2 ahead = normalized(between, {1.0, 0.0});
        const double pressing = dot(preferred_[back], ahead) - std::max(0.0, dot(now.velocity[front], ahead));
        if (pressing > 0.0) preferred_[back] -= ahead * (pressing + kGiveWay);
    }
}

void Steering::run(const SteeringDef& def, const Characters& now, const SteeringInput& input,
                   const Environment& environment, double dt, std::span<Vec2> velocity,
                   std::span<Vec2> heading, ThreadPool* pool) {
    const std::size_t count = now.size();
    preferred_.resize(count);
    topSpeed_.resize(count);
    const bool patches = !environment.patchIds().empty();
    forChunks(pool, count, kChunk, [&](std::size_t i) {
        topSpeed_[i] = patches ? def.maxSpeed * environment.ground(now.position[i]).travelSpeed
                               : def.maxSpeed;
        preferred_[i] = preferredVelocity(def, now, input, i, topSpeed_[i]);
    });
    reach_ = 2.0 * def.radius + std::max(def.separationReach, kTouchGap);
    neighbours_.findPairs(now.position, reach_, pairs_);
    addSidesteps(def, now);
    holdBack(def, now);
    const StepBounds bounds{std::min(1.0, def.velocityGain * dt), def.acceleration * dt,
                            std::min(1.0, kTurnRate * dt)};
    forChunks(pool, count, kChunk, [&, bounds](std::size_t i) {
        const Vec2 next = nextVelocity(bounds, now.velocity[i], preferred_[i], topSpeed_[i]);
        const double speed = length(next);
        const Vec2 towards = speed > kWalkingSpeed ? next / speed : input.facing[i];
        velocity[i] = next;
        heading[i] = now.phase[i] == MotionPhase::Locked ? now.heading[i]
                                                         : turned(now.heading[i], towards, bounds.turn);
    });
}

}  // namespace muster
