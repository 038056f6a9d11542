// Bounding boxes.
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

}  // namespace muster
