// Ground on which somebody stands who holds it: others go round.
#pragma once

#include <algorithm>
#include <span>

#include "engine/geometry/polygon.h"
#include "muster/vec2.h"

namespace muster {

/// Who goes past somebody that holds its ground keeps so far from it [m].
inline constexpr double kHeldMargin = 0.12;

/// One who holds its ground.
struct HeldSpot {
    Vec2 position;        ///< [m]
    double radius = 0.0;  ///< Of the body, and what is kept from it [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius);
    }
    friend bool operator==(const HeldSpot&, const HeldSpot&) = default;
};

/// True where a body of `radius` [m] goes from `a` to `b` [m] without touching those who hold.
inline bool clearOf(std::span<const HeldSpot> held, Vec2 a, Vec2 b, double radius) {
    return std::none_of(held.begin(), held.end(), [&](const HeldSpot& spot) {
        const double apart = spot.radius + radius;
        return lengthSquared(closestOnSegment(a, b, spot.position) - spot.position) < apart * apart;
    });
}

/// The room at `p`, which is `clearance` without those who hold [m].
inline double clearanceBeside(std::span<const HeldSpot> held, Vec2 p, double clearance) {
    constexpr double kRounding = 1e-9;  // [m]
    for (const HeldSpot& spot : held) {
        const double reach = std::max(0.0, clearance + spot.radius + kRounding);
        if (lengthSquared(p - spot.position) < reach * reach)
            clearance = std::min(clearance, distance(p, spot.position) - spot.radius);
    }
    return clearance;
}

}  // namespace muster
