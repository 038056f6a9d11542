// Ground whose left and right side are joined: distances go the short way round (periodic boundary).
#pragma once

#include "muster/vec2.h"

namespace muster {

/// A ring along x, or open ground.
struct Ring {
    double left = 0.0;    ///< Coordinate x of the left side [m].
    double length = 0.0;  ///< Distance from the left side to the right one [m]; 0 for open ground.

    /// The vector from one point to the nearest image of another [m].
    Vec2 between(Vec2 from, Vec2 to) const {
        Vec2 way = to - from;
        if (length > 0.0) {
            if (way.x > 0.5 * length) way.x -= length;
            if (way.x < -0.5 * length) way.x += length;
        }
        return way;
    }
    /// The shift in x by which a point that has walked out comes in on the other side [m].
    double shiftOf(double x) const {
        if (length <= 0.0) return 0.0;
        return x >= left + length ? -length : x < left ? length : 0.0;
    }
};

}  // namespace muster
