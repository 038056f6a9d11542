// Where a point lies on a field.
#pragma once

#include <algorithm>

#include "muster/base/grid.h"

namespace muster {

/// Where a point lies between the four cell centres around it.
struct BetweenCentres {
    Cell low;         ///< The lower left one.
    double fx = 0.0;  ///< Share of the way to the next column.
    double fy = 0.0;  ///< Share of the way to the next row.
};

/// The centres around a point told in cells from the grid's corner; the nearest ones beyond the outermost.
inline BetweenCentres betweenCentresAt(const Grid& grid, double x, double y) {
    const double u = Grid::bounded(x - 0.5, 0.0, static_cast<double>(grid.width - 1));
    const double v = Grid::bounded(y - 0.5, 0.0, static_cast<double>(grid.height - 1));
    const Cell low{std::min(static_cast<std::int32_t>(u), std::max(0, grid.width - 2)),
                   std::min(static_cast<std::int32_t>(v), std::max(0, grid.height - 2))};
    return {low, u - low.x, v - low.y};
}

/// The same for a point [m].
inline BetweenCentres betweenCentres(const Grid& grid, Vec2 p) {
    return betweenCentresAt(grid, (p.x - grid.origin.x) / grid.cell, (p.y - grid.origin.y) / grid.cell);
}

}  // namespace muster
