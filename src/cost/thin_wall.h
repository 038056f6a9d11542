// Walls thinner than a cell.
#pragma once

#include <cmath>

namespace muster {

/// True where a step of (dx, dy) from a point at a wall to another leads into the wall of the one and out of
/// that of the other: they lie at the two sides of a thin wall. Normals are unit vectors away from the walls,
/// null for points at none.
template <class From, class To>
bool throughThinWall(const From& from, const To& to, float dx, float dy) {
    constexpr float kSteep = 0.5f;
    if (from.normalX * to.normalX + from.normalY * to.normalY >= -kSteep) return false;
    const float most = -kSteep * std::sqrt(dx * dx + dy * dy);
    return dx * from.normalX + dy * from.normalY < most && -(dx * to.normalX + dy * to.normalY) < most;
}

}  // namespace muster
