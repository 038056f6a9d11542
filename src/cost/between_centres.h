// Where a point lies on a field.
#pragma once

#include <algorithm>

#include "base/grid.h"

namespace muster {

/// Where a point lies between the four cell centres around it.
struct BetweenCentres {
    Cell low;         ///< The lower left one.
    double fx = 0.0;  ///< Share of the way to the next column.
    double fy = 0.0;  ///< Share of the way to the next row.
};

/// The centres around a point told in cells from the grid's corner; the nearest ones beyond the outermost.
/// `most` are the largest coordinates between centres, `last` is the lower left one of the last four.
inline BetweenCentres betweenCentresAt(double x, double y, Vec2 most, Cell last) {
    const double u = Grid::bounded(x - 0.5, 0.0, most.x);
    const double v = Grid::bounded(y - 0.5, 0.0, most.y);
    const Cell low{std::min(static_cast<std::int32_t>(u), last.x),
                   std::min(static_cast<std::int32_t>(v), last.y)};
    return {low, u - low.x, v - low.y};
}

/// The same on a grid.
inline BetweenCentres betweenCentresAt(const Grid& grid, double x, double y) {
    return betweenCentresAt(x, y, {grid.width - 1.0, grid.height - 1.0},
                            {std::max(0, grid.width - 2), std::max(0, grid.height - 2)});
}

/// The same for a point [m].
inline BetweenCentres betweenCentres(const Grid& grid, Vec2 p) {
    return betweenCentresAt(grid, (p.x - grid.origin.x) / grid.cell, (p.y - grid.origin.y) / grid.cell);
}

}  // namespace muster
