#include "fields/discomfort.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Pieces slower than this are not predicted [m/s].
constexpr double kStill = 1e-3;
// Golden-section steps; each leaves 0.618 of the interval.
constexpr int kSearchSteps = 10;
constexpr double kGolden = 0.61803398874989484820;

// The piece's effect at one time, relative to the gain. Negative beyond its range, rising with nearness, so that a
// search finds its way from there.
double valueAt(const UnitCostDef& def, const ObstaclePiece& piece, Vec2 p, double time) {
    const double away = std::max(0.0, piece.signedDistance(p - piece.velocity * time));
    const double nearness = 1.0 - away / def.discomfortRange;
    return nearness > 0.0 ? nearness * (1.0 - time / def.discomfortTime) : nearness;
}

}  // namespace

double discomfortAt(const UnitCostDef& def, const ObstaclePiece& piece, Vec2 p) {
    const double speed = length(piece.velocity);
    if (speed < kStill || !(def.discomfortTime > 0.0)) return 0.0;
    // Only while the circle round the piece is near enough to the point can there be any.
    const Vec2 ahead = piece.velocity / speed;
    const double along = dot(p - piece.centre, ahead);
    const double aside = cross(ahead, p - piece.centre);
    const double reach = piece.radius + def.discomfortRange;
    if (std::fabs(aside) >= reach) return 0.0;
    const double half = std::sqrt(reach * reach - aside * aside);
    double low = std::max(0.0, (along - half) / speed);
    double high = std::min(def.discomfortTime, (along + half) / speed);
    if (low >= high) return 0.0;
    // Both factors are concave in time where they are positive, so their product has one peak.
    double left = high - kGolden * (high - low);
    double right = low + kGolden * (high - low);
    double leftValue = valueAt(def, piece, p, left);
    double rightValue = valueAt(def, piece, p, right);
    double best = std::max({valueAt(def, piece, p, low), leftValue, rightValue});
    for (int k = 0; k < kSearchSteps; ++k) {
        if (leftValue > rightValue) {
            high = right;
            right = left;
            rightValue = leftValue;
            left = high - kGolden * (high - low);
            leftValue = valueAt(def, piece, p, left);
            best = std::max(best, leftValue);
        } else {
            low = left;
            left = right;
            leftValue = rightValue;
            right = low + kGolden * (high - low);
            rightValue = valueAt(def, piece, p, right);
            best = std::max(best, rightValue);
        }
    }
    return def.discomfortGain * std::max(0.0, best);
}

void addDiscomfort(const UnitCostDef& def, const ObstaclePiece& piece, const Grid& grid,
                   std::vector<float>& discomfort, std::vector<std::int32_t>& touched) {
    if (!piece.moving || length(piece.velocity) < kStill || !(def.discomfortTime > 0.0)) return;
    const Vec2 end = piece.centre + piece.velocity * def.discomfortTime;
    const double reach = piece.radius + def.discomfortRange;
    const Vec2 least{std::min(piece.centre.x, end.x) - reach, std::min(piece.centre.y, end.y) - reach};
    const Vec2 most{std::max(piece.centre.x, end.x) + reach, std::max(piece.centre.y, end.y) + reach};
    const Cell low = grid.cellOf(least);
    const Cell high = grid.cellOf(most);
    for (std::int32_t y = std::max(0, low.y); y <= std::min(grid.height - 1, high.y); ++y) {
        for (std::int32_t x = std::max(0, low.x); x <= std::min(grid.width - 1, high.x); ++x) {
            const auto g = static_cast<float>(discomfortAt(def, piece, grid.centre({x, y})));
            if (!(g > 0.0f)) continue;
            float& here = discomfort[grid.index({x, y})];
            if (here == 0.0f) touched.push_back(grid.index({x, y}));
            here = std::max(here, g);
        }
    }
}

}  // namespace muster
