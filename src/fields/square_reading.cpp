// Reading a field for interpolation between fields.
#include <limits>

#include "fields/between_centres.h"
#include "fields/front.h"
#include "muster/fields/eikonal.h"

namespace muster {
namespace {

// Interpolates between the corners of a unit square (lower left, lower right, upper left, upper right) that are known;
// of three, the fourth is where their plane puts it.
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

double CostField::squareBetween(Vec2 p) const {
    const BetweenCentres at = betweenCentres(grid_, p);
    const std::int32_t x = at.low.x - low_.x;
    const std::int32_t y = at.low.y - low_.y;
    double v[4];
    bool known[4];
    if (x >= 0 && y >= 0 && x + 1 < width_ && y + 1 < height_) {
        const float* low = values_.data() + static_cast<std::size_t>(y) * width_ + x;
        const float* high = low + width_;
        v[0] = low[0];
        v[1] = low[1];
        v[2] = high[0];
        v[3] = high[1];
    } else {
        for (int k = 0; k < 4; ++k) v[k] = value({at.low.x + (k & 1), at.low.y + (k >> 1)});
    }
    bool all = true;
    bool any = false;
    for (int k = 0; k < 4; ++k) {
        known[k] = v[k] < kInfiniteCost;
        all = all && known[k];
        any = any || known[k];
        v[k] *= v[k];
    }
    if (all) {
        const double below = v[0] + (v[1] - v[0]) * at.fx;
        const double above = v[2] + (v[3] - v[2]) * at.fx;
        return below + (above - below) * at.fy;
    }
    return any ? betweenKnown(v, known, at.fx, at.fy) : std::numeric_limits<double>::infinity();
}

std::int32_t CostField::corners(Vec2 p, std::span<Vec2> corners) const {
    const Cell c = grid_.nearestCell(p);
    std::int32_t number = rootOf(c);
    if (number <= 0) return -1;
    std::int32_t count = 0;
    while (number > 0 && roots_[number].parent > 0 && count < static_cast<std::int32_t>(corners.size())) {
        const Root& root = roots_[number];
        corners[count++] = grid_.origin + Vec2{root.x + 0.5, root.y + 0.5} * grid_.cell;
        number = root.parent;
    }
    return count;
}

}  // namespace muster
