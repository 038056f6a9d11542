#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bilinear.h"
#include "eikonal/cost_field.h"
#include "eikonal/start_disc.h"

namespace muster {
namespace {

// Nearer to a root than this the slope leads round it [cells, squared].
constexpr double kNearRoot = 0.1;
// A slope along a wall below this share of the one into it is none.
constexpr double kRidge = 0.05;

}  // namespace

// Where the value of a cell is kept; -1 outside the window.
std::int32_t CostField::indexOf(Cell cell) const {
    const std::int32_t x = cell.x - low_.x;
    const std::int32_t y = cell.y - low_.y;
    return x < 0 || y < 0 || x >= width_ || y >= height_ ? -1 : y * width_ + x;
}

float CostField::value(Cell cell) const {
    const std::int32_t at = indexOf(cell);
    return at >= 0 ? values_[at] : kInfiniteCost;
}

void CostField::lowerValue(Cell cell, float value) {
    const std::int32_t index = indexOf(cell);
    const auto at = static_cast<std::size_t>(index);
    if (index < 0 || !(value < values_[at])) return;
    values_[at] = value;
    if (at < root_.size()) root_[at] = 0;
}

double CostField::cost(Vec2 p) const {
    if (!isFinite(p) || values_.empty()) return kInfiniteCost;
    if (lengthSquared(p - source_) <= nearRadius_ * nearRadius_) {
        const double near = stepCost(nearCost_, source_ - p);
        if (near < kInfiniteCost) return near;
    }
    Vec2 ignored;
    const double straight = straightCostAt(p, ignored);
    if (straight < kInfiniteCost) return straight;
    const BilinearPoint at = bilinearPoint(grid_, p);
    double sum = 0.0;
    double weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        const double weight = ((k & 1) != 0 ? at.fx : 1.0 - at.fx) * ((k & 2) != 0 ? at.fy : 1.0 - at.fy);
        const double corner = cornerValue(at.low, k);
        if (!(corner < kInfiniteCost)) continue;
        // A corner on whose side the point lies with no weight still counts where it is the only one.
        const double share = std::max(weight, 1e-12);
        sum += share * corner;
        weights += share;
    }
    return weights > 0.0 ? sum / weights : kInfiniteCost;
}

// Value of corner k of the square above and right of `low`. Where it is not reached (a wall), what the slope
// of the row or column through it says, so that costs rise evenly up to a wall.
double CostField::cornerValue(Cell low, int k) const {
    const Cell c{low.x + (k & 1), low.y + (k >> 1)};
    const float own = value(c);
    if (own < kInfiniteCost) return own;
    const std::int32_t inX = (k & 1) != 0 ? -1 : 1;
    const std::int32_t inY = (k & 2) != 0 ? -1 : 1;
    const auto along = [&](std::int32_t dx, std::int32_t dy) {
        const double near = value({c.x + dx, c.y + dy});
        const double far = value({c.x + 2 * dx, c.y + 2 * dy});
        return far < kInfiniteCost ? std::max(0.0, 2.0 * near - far) : static_cast<double>(kInfiniteCost);
    };
    const double x = along(inX, 0);
    const double y = along(0, inY);
    if (x < kInfiniteCost && y < kInfiniteCost) return 0.5 * (x + y);
    return std::min(x, y);
}

Vec2 CostField::direction(Vec2 p) const {
    if (!isFinite(p) || values_.empty()) return {};
    if (lengthSquared(p - source_) <= nearRadius_ * nearRadius_) return normalized(source_ - p);
    const BilinearPoint at = bilinearPoint(grid_, p);
    double v[4];
    bool reached[4];
    for (int k = 0; k < 4; ++k) {
        v[k] = cornerValue(at.low, k);
        reached[k] = value({at.low.x + (k & 1), at.low.y + (k >> 1)}) < kInfiniteCost;
    }
    // In the open straight to the root.
    if (reached[0] && reached[1] && reached[2] && reached[3]) {
        Vec2 towards;
        if (straightCostAt(p, towards) < kInfiniteCost && lengthSquared(towards) > kNearRoot)
            return normalized(towards);
    }
    // A slope along one edge of the square of centres, where both its ends have a value.
    const auto slope = [&](int a, int b, int c, int d, double share) {
        double sum = 0.0;
        double weights = 0.0;
        const auto add = [&](int from, int to, double weight) {
            if (!(v[from] < kInfiniteCost) || !(v[to] < kInfiniteCost)) return;
            sum += std::max(weight, 1e-9) * (v[to] - v[from]);
            weights += std::max(weight, 1e-9);
        };
        add(a, b, 1.0 - share);
        add(c, d, share);
        return weights > 0.0 ? sum / weights : 0.0;
    };
    Vec2 down{-slope(0, 1, 2, 3, at.fy), -slope(0, 2, 1, 3, at.fx)};
    // Not into a side where nothing is reached.
    const bool left = reached[0] || reached[2];
    const bool right = reached[1] || reached[3];
    const bool below = reached[0] || reached[1];
    const bool above = reached[2] || reached[3];
    const bool stoppedX = (down.x < 0.0 && !left) || (down.x > 0.0 && !right);
    const bool stoppedY = (down.y < 0.0 && !below) || (down.y > 0.0 && !above);
    // Before a wall or dear ground, where both ways round cost the same, the slope leads nowhere: one of them
    // is taken.
    const bool flatX = std::fabs(down.x) < kRidge * std::fabs(down.y);
    const bool flatY = std::fabs(down.y) < kRidge * std::fabs(down.x);
    if (flatY && (stoppedX || risesAhead(at.low, down.x, {1, 0})))
        down.y = std::fabs(down.x) * sideStep(at.low, {0, 1});
    if (flatX && (stoppedY || risesAhead(at.low, down.y, {0, 1})))
        down.x = std::fabs(down.y) * sideStep(at.low, {1, 0});
    if (stoppedX) down.x = 0.0;
    if (stoppedY) down.y = 0.0;
    down = normalized(down);
    // Who stands nearer to such a side than to the reached cells is too near to a wall: it also leads away
    // from there.
    if (!left || !right) down.x += left ? std::min(0.0, 0.5 - at.fx) : std::max(0.0, 0.5 - at.fx);
    if (!below || !above) down.y += below ? std::min(0.0, 0.5 - at.fy) : std::max(0.0, 0.5 - at.fy);
    down = normalized(down);
    return down == Vec2{} ? towardsReached(p) : down;
}

// The cheaper of the two cells of a square of centres, or beyond it, that lie `along` cells from its low side
// on `axis`.
float CostField::cheapestAcross(Cell low, Cell axis, std::int32_t along) const {
    const Cell c{low.x + along * axis.x, low.y + along * axis.y};
    return std::min(value(c), value({c.x + axis.y, c.y + axis.x}));
}

// True where the cost falls along `axis` (to the side of `sign`) up to the edge of the square of centres
// only, and grows again beyond it. Only the source is a true minimum, so it is not to be near.
bool CostField::risesAhead(Cell low, double sign, Cell axis) const {
    const double clear = nearRadius_ + 3.0 * grid_.cell;
    if (lengthSquared(grid_.centre(low) - source_) <= clear * clear) return false;
    const float edge = cheapestAcross(low, axis, sign > 0.0 ? 1 : 0);
    const float beyond = cheapestAcross(low, axis, sign > 0.0 ? 2 : -1);
    return beyond < kInfiniteCost && beyond > edge;
}

// Towards the cheaper of the cells beyond the square of centres on either side along `axis`: 1 or -1, 1 where
// they tie.
double CostField::sideStep(Cell low, Cell axis) const {
    const float ahead = cheapestAcross(low, axis, 2);
    const float behind = cheapestAcross(low, axis, -1);
    if (!(ahead < kInfiniteCost) && !(behind < kInfiniteCost)) return 0.0;
    return ahead <= behind ? 1.0 : -1.0;
}

// The direction to the cheapest way on over the centres of reached cells near by.
Vec2 CostField::towardsReached(Vec2 p) const {
    const Cell middle = grid_.nearestCell(p);
    constexpr std::int32_t kReach = 3;
    double best = std::numeric_limits<double>::infinity();
    Vec2 to = p;
    for (std::int32_t y = middle.y - kReach; y <= middle.y + kReach; ++y) {
        for (std::int32_t x = middle.x - kReach; x <= middle.x + kReach; ++x) {
            const float here = value({x, y});
            if (!(here < kInfiniteCost)) continue;
            const double away = distance(grid_.centre({x, y}), p);
            // Nearness first; among the near the cheaper one.
            const double price = 4.0 * away + here;
            if (away > 1e-9 && price < best) {
                best = price;
                to = grid_.centre({x, y});
            }
        }
    }
    return normalized(to - p);
}

}  // namespace muster
