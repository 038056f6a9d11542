// Bounding boxes and means of points.
#pragma once

#include <algorithm>
#include <span>

#include "muster/assert.h"
#include "muster/vec2.h"

namespace muster {

/// The smallest axis-aligned box around at least one point.
inline Box boundsOf(std::span<const Vec2> points) {
    MUSTER_ASSERT(!points.empty());
    Box box{points[0], points[0]};
    for (const Vec2 p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

/// The mean of points; zero for none.
inline Vec2 meanOf(std::span<const Vec2> points) {
    Vec2 sum;
    for (const Vec2 p : points) sum += p;
    return sum / std::max(1.0, static_cast<double>(points.size()));
}

}  // namespace muster
