// Pseudo-sources: the points from which shortest paths run straight (Mitchell, Mount and Papadimitriou 1987).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace muster {

/// The source of a cost field, or a point at a wall where shortest paths to the source bend. Behind the
/// corner it acts as a source of its own.
struct PseudoSource {
    float x = 0.0f;           ///< Point along x, from the centre of cell (0, 0) [cells].
    float y = 0.0f;           ///< Point along y, from the centre of cell (0, 0) [cells].
    float cost = 0.0f;        ///< Cost from the point to the source, divided by the edge of a cell.
    float unit = 0.0f;        ///< Unit cost of the ground around it.
    float normalX = 0.0f;     ///< Unit vector away from the wall at which it lies; null for the source.
    float normalY = 0.0f;     ///< Unit vector away from the wall at which it lies; null for the source.
    std::int32_t parent = 0;  ///< Index of the pseudo-source that the path goes on to; 0 for the source.

    /// Elevation of a point above the tangent of the wall at this pseudo-source: the sine of the angle,
    /// negative below the tangent; 1 where there is no wall.
    float elevation(float px, float py) const {
        if (normalX == 0.0f && normalY == 0.0f) return 1.0f;
        const float dx = px - x;
        const float dy = py - y;
        return (dx * normalX + dy * normalY) / std::max(1e-6f, std::sqrt(dx * dx + dy * dy));
    }
    /// Cost of the straight path from a point over this pseudo-source, given a line of sight.
    float costAt(float px, float py) const {
        const float dx = px - x;
        const float dy = py - y;
        return cost + unit * std::sqrt(dx * dx + dy * dy);
    }
};

}  // namespace muster
