// Reading a field for interpolation between fields.
#include <limits>

#include "base/bilinear.h"
#include "eikonal/cost_field.h"
#include "eikonal/front.h"

namespace muster {
namespace {

// Interpolates between the corners of a unit square (lower left, lower right, upper left, upper right) that
// are known; of three, the fourth is where their plane puts it.
double betweenKnown(const double* v, const bool* known, double fx, double fy) {
    double w[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
    const int count = known[0] + known[1] + known[2] + known[3];
    if (count == 3) {
        int lost = 0;
        while (known[lost]) ++lost;
        w[lost ^ 1] += w[lost];
        w[lost ^ 2] += w[lost];
        w[lost ^ 3] -= w[lost];
        w[lost] = 0.0;
    }
    double sum = 0.0;
    double weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        if (!known[k]) continue;
        // Where only the far side is known it still counts.
        const double share = count == 3 ? w[k] : w[k] + 1e-9;
        sum += share * v[k];
        weights += share;
    }
    return sum / weights;
}

}  // namespace

double CostField::squaredCost(Vec2 p) const {
    const BilinearPoint at = bilinearPoint(grid_, p);
    const std::int32_t x = at.low.x - low_.x;
    const std::int32_t y = at.low.y - low_.y;
    if (x < 0 || y < 0 || x + 1 >= width_ || y + 1 >= height_) return squareOfKnown(at.low, at.fx, at.fy);
    const float* low = values_.data() + static_cast<std::size_t>(y) * width_ + x;
    const float* high = low + width_;
    // Nearly always all four are known: squares between them at once.
    const bool all = low[0] < kInfiniteCost && low[1] < kInfiniteCost && high[0] < kInfiniteCost &&
                     high[1] < kInfiniteCost;
    if (!all) return squareOfKnown(at.low, at.fx, at.fy);
    const auto square = [](double value) { return value * value; };
    const double lowLeft = square(low[0]);
    const double highLeft = square(high[0]);
    const double below = lowLeft + (square(low[1]) - lowLeft) * at.fx;
    const double above = highLeft + (square(high[1]) - highLeft) * at.fx;
    return below + (above - below) * at.fy;
}

// The same where not all four centres may be reached, `low` being the lower left one.
double CostField::squareOfKnown(Cell low, double fx, double fy) const {
    double v[4];
    bool known[4];
    bool any = false;
    for (int k = 0; k < 4; ++k) {
        v[k] = value({low.x + (k & 1), low.y + (k >> 1)});
        known[k] = v[k] < kInfiniteCost;
        any = any || known[k];
        v[k] *= v[k];
    }
    return any ? betweenKnown(v, known, fx, fy) : std::numeric_limits<double>::infinity();
}

std::int32_t CostField::pathCorners(Vec2 p, std::span<Vec2> corners) const {
    const Cell c = grid_.nearestCell(p);
    std::int32_t number = rootOf(c);
    if (number <= 0) return -1;
    std::int32_t count = 0;
    while (number > 0 && roots_[number].parent > 0 && count < static_cast<std::int32_t>(corners.size())) {
        const PseudoSource& root = roots_[number];
        corners[count++] = grid_.origin + Vec2{root.x + 0.5, root.y + 0.5} * grid_.cell;
        number = root.parent;
    }
    return count;
}

}  // namespace muster
