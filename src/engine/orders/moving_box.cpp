#include "engine/orders/moving_box.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr TimeSpan kNoSpan{1.0, 0.0};

/// The time while |offset + velocity t| is at most `reach`.
TimeSpan within(double offset, double velocity, double reach, TimeSpan span) {
    if (std::fabs(velocity) < 1e-12) return std::fabs(offset) <= reach ? span : kNoSpan;
    const double a = (-reach - offset) / velocity, b = (reach - offset) / velocity;
    return {std::max(span.from, std::min(a, b)), std::min(span.to, std::max(a, b))};
}

/// The time while two circles meet.
TimeSpan within(Vec2 offset, Vec2 velocity, double reach, TimeSpan span) {
    const double speed2 = lengthSquared(velocity);
    const double outside = lengthSquared(offset) - reach * reach;
    if (speed2 < 1e-24) return outside <= 0.0 ? span : kNoSpan;
    const double approach = dot(offset, velocity);
    const double root = approach * approach - speed2 * outside;
    if (root < 0.0) return kNoSpan;
    const double half = std::sqrt(root);
    return {std::max(span.from, (-approach - half) / speed2), std::min(span.to, (-approach + half) / speed2)};
}

double extentAlong(const MovingBox& box, Vec2 n) {
    return box.half.x * std::fabs(dot(n, box.axis)) + box.half.y * std::fabs(cross(n, box.axis)) + box.round;
}

}  // namespace

TimeSpan contactSpan(const MovingBox& a, const MovingBox& b, double margin) {
    TimeSpan span{std::max(a.from, b.from), std::min(a.to, b.to)};
    if (span.empty()) return kNoSpan;
    const Vec2 offset = b.centre - a.centre, velocity = b.velocity - a.velocity;
    const TimeSpan circles = within(offset, velocity, a.reach() + b.reach() + 1.5 * margin, span);
    const bool discs = a.half == Vec2{} && b.half == Vec2{};
    if (circles.empty()) return kNoSpan;
    if (discs) return within(offset, velocity, a.round + b.round + margin, span);
    for (const Vec2 n : {a.axis, perpendicular(a.axis), b.axis, perpendicular(b.axis)}) {
        const double reach = extentAlong(a, n) + extentAlong(b, n) + margin;
        span = within(dot(n, offset), dot(n, velocity), reach, span);
        if (span.empty()) return kNoSpan;
    }
    return span;
}

}  // namespace muster
