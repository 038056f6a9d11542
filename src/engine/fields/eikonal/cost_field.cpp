#include "engine/fields/eikonal/cost_field.h"

#include <algorithm>
#include <cmath>

#include "base/bilinear.h"
#include "engine/fields/eikonal/source_initialisation.h"

namespace muster {

// Index of a cell in the stored rectangle; -1 outside.
std::int32_t CostField::indexOf(Cell cell) const {
    const std::int32_t x = cell.x - low_.x;
    const std::int32_t y = cell.y - low_.y;
    return x < 0 || y < 0 || x >= width_ || y >= height_ ? -1 : y * width_ + x;
}

float CostField::value(Cell cell) const {
    const std::int32_t at = indexOf(cell);
    return at >= 0 ? values_[at] : kUnreachableCost;
}

void CostField::lowerValue(Cell cell, float value) {
    const std::int32_t at = indexOf(cell);
    if (at < 0 || !(value < values_[at])) return;
    values_[at] = value;
    sourceOf_[at] = 0;
}

double CostField::cost(Vec2 p) const {
    if (!isFinite(p) || values_.empty()) return kUnreachableCost;
    if (lengthSquared(p - source_) <= uniformRadius_ * uniformRadius_) {
        const double straight = stepCost(sourceCost_, source_ - p);
        if (straight < kUnreachableCost) return straight;
    }
    Vec2 ignored;
    const double exact = exactCost(p, ignored);
    if (exact < kUnreachableCost) return exact;
    const BilinearPoint at = bilinearPoint(grid_, p);
    const unsigned side = sameSide(at.low, p);
    double sum = 0.0;
    double weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        const double weight = ((k & 1) != 0 ? at.fx : 1.0 - at.fx) * ((k & 2) != 0 ? at.fy : 1.0 - at.fy);
        const double corner = cornerValue(at.low, k, side);
        if (!(corner < kUnreachableCost)) continue;
        // A corner of weight zero counts where it is the only one.
        const double share = std::max(weight, 1e-12);
        sum += share * corner;
        weights += share;
    }
    return weights > 0.0 ? sum / weights : kUnreachableCost;
}

// Value of corner k of the square of centres above and right of `low`. A corner that is not reached, in a
// wall, gets the extrapolation of its row and column, so that costs rise evenly up to a wall.
double CostField::cornerValue(Cell low, int k, unsigned side) const {
    const Cell c{low.x + (k & 1), low.y + (k >> 1)};
    const float own = valueOf(low, k, side);
    if (own < kUnreachableCost) return own;
    const std::int32_t inX = (k & 1) != 0 ? -1 : 1;
    const std::int32_t inY = (k & 2) != 0 ? -1 : 1;
    const auto extrapolate = [&](std::int32_t dx, std::int32_t dy) {
        const double near = valueOf(low, dx != 0 ? k ^ 1 : k ^ 2, side);
        const double far = value({c.x + 2 * dx, c.y + 2 * dy});
        const bool known = near < kUnreachableCost && far < kUnreachableCost;
        return known ? std::max(0.0, 2.0 * near - far) : static_cast<double>(kUnreachableCost);
    };
    const double x = extrapolate(inX, 0);
    const double y = extrapolate(0, inY);
    if (x < kUnreachableCost && y < kUnreachableCost) return 0.5 * (x + y);
    return std::min(x, y);
}

}  // namespace muster
