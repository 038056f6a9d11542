#include "cost/ground_level.h"

#include <limits>

namespace muster {

std::int32_t GroundLevel::freeCellNear(Vec2 p) const {
    constexpr std::int32_t kReach = 2;
    const Grid& grid = cost.grid;
    const Cell middle = grid.nearestCell(p);
    std::int32_t found = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int32_t y = middle.y - kReach; y <= middle.y + kReach; ++y)
        for (std::int32_t x = middle.x - kReach; x <= middle.x + kReach; ++x) {
            if (!grid.contains({x, y}) || blocked(grid.index({x, y}))) continue;
            const double d = lengthSquared(grid.centre({x, y}) - p);
            if (d >= nearest) continue;
            nearest = d;
            found = grid.index({x, y});
        }
    return found;
}

}  // namespace muster
