// Walls thinner than a cell.
#pragma once

#include <cmath>

namespace muster {

/// True where the line from one point at a wall to another crosses a thin wall: the points lie on its two
/// sides, so that the line (dx, dy) enters the wall of the one and leaves that of the other. Normals are unit
/// vectors away from the walls, null for points that are not at a wall.
template <class From, class To>
bool crossesThinWall(const From& from, const To& to, float dx, float dy) {
    // The normals are more than 120 degrees apart, and the line meets both walls at more than 30 degrees.
    constexpr float kHalf = 0.5f;
    if (from.normalX * to.normalX + from.normalY * to.normalY >= -kHalf) return false;
    const float most = -kHalf * std::sqrt(dx * dx + dy * dy);
    return dx * from.normalX + dy * from.normalY < most && -(dx * to.normalX + dy * to.normalY) < most;
}

}  // namespace muster
