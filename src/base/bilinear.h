// Bilinear interpolation between the cell centres of a grid.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/grid.h"

namespace muster {

/// The square of four neighbouring cell centres that holds a point, and where in the square the point lies.
struct BilinearPoint {
    Cell low;         ///< The lower left cell of the four.
    double fx = 0.0;  ///< Fraction of the way from the left to the right column [0 to 1].
    double fy = 0.0;  ///< Fraction of the way from the lower to the upper row [0 to 1].
};

/// The four cells around a point with their bilinear weights.
struct BilinearStencil {
    std::int32_t cell[4];  ///< Row-major indices: lower left, lower right, upper left, upper right.
    double weight[4];      ///< Sum 1, each >= 0.
};

/// Locates the point (x, y), given in cells from the grid's lower left corner. A point outside the outermost
/// centres is moved to the nearest point between them. `most` are the largest coordinates of a centre,
/// counted from the first one; `last` is the lower left cell of the last square.
inline BilinearPoint bilinearPoint(double x, double y, Vec2 most, Cell last) {
    const double u = Grid::bounded(x - 0.5, 0.0, most.x);
    const double v = Grid::bounded(y - 0.5, 0.0, most.y);
    const Cell low{std::min(static_cast<std::int32_t>(u), last.x),
                   std::min(static_cast<std::int32_t>(v), last.y)};
    return {low, u - low.x, v - low.y};
}

/// Locates a point on a grid of at least one cell.
inline BilinearPoint bilinearPoint(const Grid& grid, double x, double y) {
    return bilinearPoint(x, y, {grid.width - 1.0, grid.height - 1.0},
                         {std::max(0, grid.width - 2), std::max(0, grid.height - 2)});
}

/// Locates a point given in metres.
inline BilinearPoint bilinearPoint(const Grid& grid, Vec2 p) {
    return bilinearPoint(grid, (p.x - grid.origin.x) / grid.cell, (p.y - grid.origin.y) / grid.cell);
}

/// The four cells around a point with their weights. In a grid of a single column or row both columns or rows
/// of the stencil are that one.
inline BilinearStencil bilinearStencil(const Grid& grid, Vec2 p) {
    const auto [at, fx, fy] = bilinearPoint(grid, p);
    const std::int32_t low = grid.index(at);
    const std::int32_t right = grid.width > 1 ? 1 : 0;
    const std::int32_t high = low + (grid.height > 1 ? grid.width : 0);
    return {{low, low + right, high, high + right},
            {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

/// Interpolates the values at the corners of a square of centres.
template <class Value, class Fraction>
auto interpolateBilinear(Value lowerLeft, Value lowerRight, Value upperLeft, Value upperRight, Fraction fx,
                         Fraction fy) {
    const auto below = lowerLeft + (lowerRight - lowerLeft) * fx;
    const auto above = upperLeft + (upperRight - upperLeft) * fx;
    return below + (above - below) * fy;
}

/// Locates points on one grid, with the grid's constants prepared: for many readings of float values.
class BilinearLocator {
public:
    /// The lower left cell of the four around a point, and where the point lies between them.
    struct Location {
        std::int32_t low;  ///< Row-major index.
        float fx;          ///< Fraction of the way to the next column [0 to 1].
        float fy;          ///< Fraction of the way to the next row [0 to 1].
    };

    BilinearLocator() = default;  ///< A locator of no grid: assign one before the first query.
    /// Prepares the constants of a grid of at least one cell.
    explicit BilinearLocator(const Grid& grid)
        : origin_(grid.origin),
          perMetre_(1.0 / grid.cell),
          most_{grid.width - 1.0, grid.height - 1.0},
          last_{std::max(0, grid.width - 2), std::max(0, grid.height - 2)},
          width_(grid.width),
          right_(grid.width > 1 ? 1 : 0),
          up_(grid.height > 1 ? grid.width : 0) {}

    /// Locates a point [m].
    Location at(Vec2 p) const {
        const BilinearPoint found = point(p);
        return {found.low.y * width_ + found.low.x, static_cast<float>(found.fx),
                static_cast<float>(found.fy)};
    }
    /// Locates a point [m] by column and row.
    BilinearPoint point(Vec2 p) const {
        return bilinearPoint((p.x - origin_.x) * perMetre_, (p.y - origin_.y) * perMetre_, most_, last_);
    }
    /// Step of the index from a cell of the left column to the right one; 0 in a grid of one column.
    std::int32_t right() const { return right_; }
    /// Step of the index from a cell of the lower row to the upper one; 0 in a grid of one row.
    std::int32_t up() const { return up_; }

private:
    Vec2 origin_;             // Lower left corner of the grid [m].
    double perMetre_ = 1.0;   // Cells per metre [1/m].
    Vec2 most_;               // Largest coordinates of a centre, counted from the first one [cells].
    Cell last_;               // Lower left cell of the last square of centres.
    std::int32_t width_ = 0;  // Columns of the grid.
    std::int32_t right_ = 0;
    std::int32_t up_ = 0;
};

}  // namespace muster
