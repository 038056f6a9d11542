// Search for a point on rings about a centre, from the inside out.
#pragma once

#include <cstdint>

#include "base/maths.h"
#include "muster/vec2.h"

namespace muster {

/// Calls `accept(point)` for points on up to 8 rings about `centre`, until it returns true; returns whether
/// it did. Rings and points are slightly more than `separation` [m] apart; rings wider than `maxRadius` [m]
/// are left out. Each rejected point lowers `budget` by one.
template <class Accept>
bool searchRings(Vec2 centre, double separation, double maxRadius, std::int32_t& budget,
                 const Accept& accept) {
    constexpr std::int32_t kRings = 8;
    for (std::int32_t ring = 1; ring <= kRings; ++ring) {
        const double radius = 1.01 * separation * ring;
        if (radius > maxRadius) return false;
        const std::int32_t points = 6 * ring;
        for (std::int32_t k = 0; k < points; ++k, --budget) {
            const double angle = 2.0 * kPi * (k + 0.5 * (ring % 2)) / points;
            if (accept(centre + Vec2{cosine(angle), sine(angle)} * radius)) return true;
        }
    }
    return false;
}

}  // namespace muster
