#include "engine/orders/march.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kBackwards = 0.5 * kPi;  // From here on the way leads back [rad].
constexpr double kOnTheSpot = 1.3;        // From here on it only turns [rad].
constexpr double kSpinGain = 2.5;         // Rate of turn per angle [1/s].
constexpr double kWheelShare = 0.65;      // Of its speed that goes into turning while it goes on.
constexpr double kTurned = 1e-4;          // A smaller angle is none [rad].
constexpr double kLeastAim = 1.5;         // It heads for a point so far ahead on its way at least [m]...
constexpr double kMostAim = 8.0;          // ... and at most [m].

double approach(double from, double to, double most) {
    return from + std::clamp(to - from, -most, most);
}

/// The point at a distance ahead on the way, and the corner that comes next.
Vec2 walk(const March& march, std::uint32_t& next, Vec2 from, double reach) {
    while (next < march.way.size()) {
        const Vec2 corner = march.way[next];
        const double part = distance(from, corner);
        if (part > reach) return lerp(from, corner, reach / part);
        reach -= part;
        from = corner;
        ++next;
    }
    return from;
}

/// Turns the front by `error` [rad] at most at a share of the speed.
double spinFor(const MarchDef& def, double error, double share) {
    const double fastest = share * def.speed * def.pace / def.reach;
    const double stops = std::sqrt(2.0 * 0.7 * def.acceleration / def.reach * std::fabs(error));
    const double size = std::min({fastest, stops, kSpinGain * std::fabs(error)});
    return error < 0.0 ? -size : size;
}

Pose turnBy(const MarchDef& def, March& march, const Pose& pose, double error, double share, double dt) {
    const double wanted = spinFor(def, error, share);
    march.spin = approach(march.spin, wanted, def.acceleration / def.reach * dt);
    double angle = march.spin * dt;
    if (std::fabs(error) < kTurned || (angle * error > 0.0 && std::fabs(angle) > std::fabs(error))) {
        angle = error;
        march.spin = error / dt;
    }
    return {pose.position, turned(pose.rotation, angle)};
}

Pose turnAtEnd(const MarchDef& def, March& march, const Pose& pose, double dt) {
    march.speed = 0.0;
    const Vec2 facing{cosine(march.facing), sine(march.facing)};
    double error = march.turns ? angleBetween(march.front(pose), facing) : 0.0;
    if (def.turn == Turn::Reverse && std::fabs(error) > kBackwards) {
        march.reversed = !march.reversed;
        error = angleBetween(march.front(pose), facing);
    }
    if (std::fabs(error) < kTurned) march.phase = MarchPhase::Stand;
    return turnBy(def, march, pose, error, 1.0, dt);
}

/// Share of the speed that is left where the front has to turn so far.
double alignment(double error) {
    const double least = cosine(kOnTheSpot);
    return std::clamp((cosine(error) - least) / (1.0 - least), 0.0, 1.0);
}

/// Where its front has to turn [rad], and whether that is its rear.
struct FrontError {
    double angle = 0.0;
    bool reversed = false;
};

FrontError errorOfFront(const MarchDef& def, const March& march, const Pose& pose) {
    std::uint32_t corner = march.next;
    const Vec2 aim = walk(march, corner, pose.position, std::clamp(0.5 + def.depth, kLeastAim, kMostAim));
    const Vec2 front = march.front(pose);
    const Vec2 ahead = normalized(aim - pose.position, front);
    // Near the end the way says little about where to face.
    const bool faces = def.turn != Turn::Keep && distance(aim, pose.position) > 0.5 * kLeastAim;
    const FrontError error{faces ? angleBetween(front, ahead) : 0.0, march.reversed};
    if (def.turn == Turn::Reverse && std::fabs(error.angle) > kBackwards)
        return {angleBetween(pose.rotation.apply({march.reversed ? 1.0 : -1.0, 0.0}), ahead),
                !march.reversed};
    return error;
}

double turnToWay(const MarchDef& def, March& march, const Pose& pose) {
    const FrontError error = errorOfFront(def, march, pose);
    march.reversed = error.reversed;
    return error.angle;
}

double speedAt(const MarchDef& def, const March& march, double error, double left) {
    const double wheel = std::max(0.0, def.speed - std::fabs(march.spin) * def.reach);
    const double stops = std::sqrt(2.0 * def.acceleration * left);
    return std::min({def.speed * def.pace, wheel, def.speed * alignment(error), stops});
}

}  // namespace

Rotation turned(Rotation r, double angle) {
    const double c = cosine(angle), s = sine(angle);
    Rotation out{r.c * c - r.s * s, r.s * c + r.c * s};
    const double size = std::sqrt(out.c * out.c + out.s * out.s);
    return {out.c / size, out.s / size};
}

double angleBetween(Vec2 from, Vec2 to) {
    return arcTangent2(cross(from, to), dot(from, to));
}

double lengthAhead(const March& march, Vec2 from) {
    double sum = 0.0;
    for (std::size_t k = march.next; k < march.way.size(); ++k) {
        sum += distance(from, march.way[k]);
        from = march.way[k];
    }
    return sum;
}

double wantedSpeed(const MarchDef& def, const March& march, const Pose& pose) {
    return speedAt(def, march, errorOfFront(def, march, pose).angle, lengthAhead(march, pose.position));
}

Pose advanceMarch(const MarchDef& def, March& march, const Pose& pose, double dt) {
    if (march.phase == MarchPhase::Turn) return turnAtEnd(def, march, pose, dt);
    if (march.phase != MarchPhase::Go) return pose;
    const double left = lengthAhead(march, pose.position);
    const double error = turnToWay(def, march, pose);
    const double share = std::fabs(error) > kOnTheSpot ? 1.0 : kWheelShare;
    Pose next = turnBy(def, march, pose, error, share, dt);
    const double wanted = std::min(speedAt(def, march, error, left), def.limit);
    march.speed = std::clamp(wanted, march.speed - 2.0 * def.acceleration * dt,
                             march.speed + def.acceleration * dt);
    march.speed = std::max(0.0, march.speed);
    next.position = walk(march, march.next, pose.position, march.speed * dt);
    if (left < 1e-3 || march.next >= march.way.size()) {
        if (!march.way.empty()) next.position = march.way.back();
        march.phase = MarchPhase::Turn;
    }
    return next;
}

Pose advanceOffWay(const MarchDef& def, March& march, const Pose& pose, Vec2& velocity, Vec2 wanted,
                   double dt) {
    const double error = turnToWay(def, march, pose);
    Pose next = turnBy(def, march, pose, error, kWheelShare, dt);
    velocity += clampLength(wanted - velocity, def.acceleration * dt);
    velocity = clampLength(velocity, std::max(0.0, def.speed - std::fabs(march.spin) * def.reach));
    march.speed = length(velocity);
    next.position = pose.position + velocity * dt;
    return next;
}

Pose advanceTowards(const MarchDef& def, March& march, const Pose& pose, Vec2 goal, Vec2 velocity,
                    Vec2 facing, double dt) {
    constexpr double kGain = 1.5;  // Speed per distance [1/s].
    const double error = angleBetween(march.front(pose), facing);
    Pose next = turnBy(def, march, pose, error, kWheelShare, dt);
    const Vec2 wanted = clampLength(velocity + (goal - pose.position) * kGain,
                                    std::max(0.0, def.speed * def.pace - std::fabs(march.spin) * def.reach));
    march.speed = approach(march.speed, length(wanted), def.acceleration * dt);
    next.position = pose.position + clampLength(wanted, march.speed) * dt;
    return next;
}

double marchTime(const MarchDef& def, std::span<const Vec2> way, Vec2 front, std::optional<double> facing) {
    double sum = 0.0, turns = 0.0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const Vec2 ahead = normalized(way[k] - way[k - 1], front);
        sum += distance(way[k - 1], way[k]);
        if (def.turn == Turn::Keep) continue;
        double error = std::fabs(angleBetween(front, ahead));
        if (def.turn == Turn::Reverse) error = std::min(error, kPi - error);
        turns += error;
        front = ahead;
    }
    if (facing) turns += std::fabs(angleBetween(front, {cosine(*facing), sine(*facing)}));
    const double speed = std::max(def.speed, 1e-9);
    return (sum + turns * def.reach) / speed + speed / def.acceleration;
}

}  // namespace muster
