// Interpolation of squared costs.
#include <limits>

#include "base/bilinear.h"
#include "engine/fields/eikonal/cost_field.h"

namespace muster {
namespace {

// Interpolates between the known corners of a unit square (lower left, lower right, upper left, upper right).
// A missing corner lies on the plane through the others.
double interpolateKnown(const double* v, const bool* known, double fx, double fy) {
    double w[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
    const int count = known[0] + known[1] + known[2] + known[3];
    if (count == 3) {
        int missing = 0;
        while (known[missing]) ++missing;
        w[missing ^ 1] += w[missing];
        w[missing ^ 2] += w[missing];
        w[missing ^ 3] -= w[missing];
        w[missing] = 0.0;
    }
    double sum = 0.0;
    double weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        if (!known[k]) continue;
        // A corner of weight zero counts where it is the only one.
        const double share = count == 3 ? w[k] : w[k] + 1e-9;
        sum += share * v[k];
        weights += share;
    }
    return sum / weights;
}

double square(double value) {
    return value * value;
}

}  // namespace

double CostField::squaredCost(Vec2 p) const {
    const BilinearPoint at = bilinearPoint(grid_, p);
    const std::int32_t x = at.low.x - low_.x;
    const std::int32_t y = at.low.y - low_.y;
    if (x < 0 || y < 0 || x + 1 >= width_ || y + 1 >= height_)
        return squaredCostOfReached(at.low, at.fx, at.fy);
    const float* low = values_.data() + static_cast<std::size_t>(y) * width_ + x;
    const float* high = low + width_;
    const bool allReached = low[0] < kUnreachableCost && low[1] < kUnreachableCost &&
                            high[0] < kUnreachableCost && high[1] < kUnreachableCost;
    if (!allReached) return squaredCostOfReached(at.low, at.fx, at.fy);
    return interpolateBilinear(square(low[0]), square(low[1]), square(high[0]), square(high[1]), at.fx,
                               at.fy);
}

// The squared cost where not all four cells may be reached; `low` is the lower left one.
double CostField::squaredCostOfReached(Cell low, double fx, double fy) const {
    double v[4];
    bool known[4];
    bool any = false;
    for (int k = 0; k < 4; ++k) {
        v[k] = value({low.x + (k & 1), low.y + (k >> 1)});
        known[k] = v[k] < kUnreachableCost;
        any = any || known[k];
        v[k] *= v[k];
    }
    return any ? interpolateKnown(v, known, fx, fy) : std::numeric_limits<double>::infinity();
}

}  // namespace muster
