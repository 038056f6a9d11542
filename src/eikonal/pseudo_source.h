// Where straight ways come from.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace muster {

/// A point from which ways go straight on: the source, or a place at a wall where they bend.
struct PseudoSource {
    float x = 0.0f;           ///< From the centre of cell (0, 0) [cells].
    float y = 0.0f;           ///< From the centre of cell (0, 0) [cells].
    float cost = 0.0f;        ///< Cost to the source [cells].
    float unit = 0.0f;        ///< Cost of a metre round it.
    float normalX = 0.0f;     ///< Unit vector out of the wall that it stands at; null for the source.
    float normalY = 0.0f;     ///< Unit vector out of the wall that it stands at; null for the source.
    std::int32_t parent = 0;  ///< Number of the root that it is seen from; 0 for the source.

    /// How far a point rises over the wall that the root stands at, as a sine; 1 where it stands at none.
    float rise(float px, float py) const {
        if (normalX == 0.0f && normalY == 0.0f) return 1.0f;
        const float dx = px - x;
        const float dy = py - y;
        return (dx * normalX + dy * normalY) / std::max(1e-6f, std::sqrt(dx * dx + dy * dy));
    }
    /// Cost at a point that the root sees.
    float costAt(float px, float py) const {
        const float dx = px - x;
        const float dy = py - y;
        return cost + unit * std::sqrt(dx * dx + dy * dy);
    }
};

}  // namespace muster
