#include "engine/orders/march.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/orders/turning.h"

namespace muster {
namespace {

constexpr double kSpinGain = 2.5;    // Rate of turn per angle [1/s].
constexpr double kWheelShare = 0.65;  // Of its speed that goes into turning while it goes on.
constexpr double kTurned = 1e-4;     // A smaller angle is none [rad].
constexpr double kGain = 1.5;        // Speed per distance [1/s].

double approach(double from, double to, double most) {
    return from + std::clamp(to - from, -most, most);
}

/// The rate of turn by which it takes up a heading that is off by `error` [rad].
double spinFor(const MarchDef& def, double error) {
    const double fastest = kWheelShare * def.speed * def.pace / def.reach;
    const double stops = std::sqrt(2.0 * def.acceleration / def.reach * std::fabs(error));
    const double size = std::min({fastest, stops, kSpinGain * std::fabs(error)});
    return error < 0.0 ? -size : size;
}

}  // namespace

Pose advanceTowards(const MarchDef& def, March& march, const Pose& pose, Vec2 goal, Vec2 velocity,
                    Vec2 facing, double dt) {
    const double error = angleBetween(march.front(pose), facing);
    march.spin = approach(march.spin, spinFor(def, error), def.acceleration / def.reach * dt);
    const Vec2 wanted = clampLength(velocity + (goal - pose.position) * kGain,
                                    std::max(0.0, def.speed * def.pace - std::fabs(march.spin) * def.reach));
    march.speed = approach(march.speed, length(wanted), def.acceleration * dt);
    const double angle = std::fabs(error) < kTurned ? error : march.spin * dt;
    return {pose.position + clampLength(wanted, march.speed) * dt, turned(pose.rotation, angle)};
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
