// A movement of the program's own: optimal reciprocal collision avoidance. Each body takes the velocity
// nearest to the one that it wants among those by which it meets nobody within a few seconds, if the others
// do their half.
#pragma once

#include <muster/vec2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace orca {

using muster::Vec2;

/// What moves, or stands in the way.
struct Disc {
    Vec2 position;           ///< [m]
    Vec2 velocity;           ///< [m/s]
    double radius = 0.25;    ///< [m]
    bool reciprocal = true;  ///< It does its half; false for pillars.
};

/// Velocities v with dot(v - point, normal) >= 0 are allowed.
struct HalfPlane {
    Vec2 point;
    Vec2 normal;

    double margin(Vec2 v) const { return dot(v - point, normal); }
};

/// The velocities of `a` that keep it clear of `b` for `horizon` seconds. Those that do not form a cone, cut
/// off by a circle, in the space of relative velocities; the half-plane touches it where it is nearest.
inline HalfPlane avoid(const Disc& a, const Disc& b, double horizon, double step) {
    const Vec2 apart = b.position - a.position;
    const Vec2 relative = a.velocity - b.velocity;
    const double reach = a.radius + b.radius;
    const bool touches = lengthSquared(apart) <= reach * reach;
    const double time = touches ? step : horizon;  // Who overlaps parts within one step.
    const Vec2 w = relative - apart / time;        // From the centre of the circle.
    const double along = dot(w, apart);
    Vec2 change, normal;
    if (touches || (along < 0.0 && along * along > reach * reach * lengthSquared(w))) {
        normal = normalized(w, {1.0, 0.0});
        change = normal * (reach / time - length(w));
    } else {  // A leg of the cone: the tangent from the origin to the other disc.
        const double square = lengthSquared(apart);
        const double leg = std::sqrt(square - reach * reach);
        const double side = cross(apart, w) > 0.0 ? 1.0 : -1.0;
        const Vec2 tangent{(apart.x * leg - side * apart.y * reach) / square,
                           (side * apart.x * reach + apart.y * leg) / square};
        normal = perpendicular(tangent) * side;
        change = tangent * dot(relative, tangent) - relative;
    }
    return {a.velocity + change * (b.reciprocal ? 0.5 : 1.0), normal};
}

/// The velocity nearest to `wanted` within all half-planes and the top speed; where there is none, the one
/// that breaks them least. It is one of few: the wanted one, the nearest one on a line, or a corner.
inline Vec2 choose(const std::vector<HalfPlane>& planes, Vec2 wanted, double topSpeed) {
    std::vector<Vec2> candidates{clampLength(wanted, topSpeed), {0.0, 0.0}};
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Vec2 foot = planes[i].normal * dot(planes[i].point, planes[i].normal);
        const Vec2 along = perpendicular(planes[i].normal);
        candidates.push_back(foot + along * dot(wanted, along));
        const double chord = topSpeed * topSpeed - lengthSquared(foot);
        if (chord < 0.0) continue;
        candidates.push_back(foot + along * std::sqrt(chord));
        candidates.push_back(foot - along * std::sqrt(chord));
        for (std::size_t j = 0; j < i; ++j) {
            const double slope = dot(along, planes[j].normal);
            if (std::fabs(slope) < 1e-9) continue;
            candidates.push_back(foot - along * (planes[j].margin(foot) / slope));
        }
    }
    Vec2 best;
    double leastBreach = 1e9, leastChange = 1e9;
    for (const Vec2 v : candidates) {
        if (length(v) > topSpeed * (1.0 + 1e-9)) continue;
        double breach = 0.0;
        for (const HalfPlane& plane : planes) breach = std::max(breach, -plane.margin(v));
        if (breach < 1e-7) breach = 0.0;
        const double change = lengthSquared(v - wanted);
        if (breach > leastBreach || (breach == leastBreach && change >= leastChange)) continue;
        best = v;
        leastBreach = breach;
        leastChange = change;
    }
    return best;
}

}  // namespace orca
