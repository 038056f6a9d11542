// Directions of cheapest paths: towards the pseudo-source, or down the gradient of the interpolated costs.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bilinear.h"
#include "engine/fields/eikonal/cost_field.h"

namespace muster {
namespace {

// Squared distance to a pseudo-source below which the gradient leads round it [cells^2].
constexpr double kNearSourceSquared = 0.1;
// Share of the slope at right angles below which a slope counts as zero.
constexpr double kFlatShare = 0.05;
// Distance of a point within which reached cells are searched [cells].
constexpr std::int32_t kSearchReach = 3;

// Mean slope of the square of centres along two parallel edges, from `a` to `b` and from `c` to `d`, of which
// the second has the weight `share`. Edges with an end of infinite value are left out.
double edgeSlope(const double* v, int a, int b, int c, int d, double share) {
    double sum = 0.0;
    double weights = 0.0;
    const auto add = [&](int from, int to, double weight) {
        if (!(v[from] < kUnreachableCost) || !(v[to] < kUnreachableCost)) return;
        sum += std::max(weight, 1e-9) * (v[to] - v[from]);
        weights += std::max(weight, 1e-9);
    };
    add(a, b, 1.0 - share);
    add(c, d, share);
    return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace

Vec2 CostField::direction(Vec2 p) const {
    if (!isFinite(p) || values_.empty()) return {};
    if (lengthSquared(p - source_) <= uniformRadius_ * uniformRadius_) return normalized(source_ - p);
    const BilinearPoint at = bilinearPoint(grid_, p);
    bool allReached = true;
    const unsigned side = sameSide(at.low, p);
    for (int k = 0; k < 4; ++k) allReached = allReached && valueOf(at.low, k, side) < kUnreachableCost;
    Vec2 towards;
    if (allReached && exactCost(p, towards) < kUnreachableCost && lengthSquared(towards) > kNearSourceSquared)
        return normalized(towards);
    const Vec2 down = descent(p);
    return down == Vec2{} ? towardsReached(p) : down;
}

FieldWay CostField::way(Vec2 p) const {
    Vec2 towards;
    std::int32_t over = 0;
    const double exact = isFinite(p) && !values_.empty() ? exactCost(p, towards, over) : kUnreachableCost;
    if (!(exact < kUnreachableCost) || lengthSquared(towards) <= kNearSourceSquared)
        return {cost(p), direction(p)};
    const BilinearPoint at = bilinearPoint(grid_, p);
    const unsigned side = sameSide(at.low, p);
    for (int k = 0; k < 4; ++k)
        if (!(valueOf(at.low, k, side) < kUnreachableCost)) return {exact, direction(p)};
    return {exact, normalized(towards), sources_[over].parent == 0};
}

// Direction of steepest descent of the bilinear interpolant, changed at walls and at ridges; null where it is
// undefined.
Vec2 CostField::descent(Vec2 p) const {
    const BilinearPoint at = bilinearPoint(grid_, p);
    const unsigned side = sameSide(at.low, p);
    double v[4];
    bool reached[4];
    for (int k = 0; k < 4; ++k) {
        v[k] = cornerValue(at.low, k, side);
        reached[k] = valueOf(at.low, k, side) < kUnreachableCost;
    }
    Vec2 down{-edgeSlope(v, 0, 1, 2, 3, at.fy), -edgeSlope(v, 0, 2, 1, 3, at.fx)};
    // Components towards a side where no cell is reached are removed.
    const bool left = reached[0] || reached[2];
    const bool right = reached[1] || reached[3];
    const bool below = reached[0] || reached[1];
    const bool above = reached[2] || reached[3];
    const bool stoppedX = (down.x < 0.0 && !left) || (down.x > 0.0 && !right);
    const bool stoppedY = (down.y < 0.0 && !below) || (down.y > 0.0 && !above);
    // On a ridge, exactly before a wall or expensive ground where both paths round it cost the same, the
    // gradient points at the obstacle: one of the two paths is chosen.
    const bool flatX = std::fabs(down.x) < kFlatShare * std::fabs(down.y);
    const bool flatY = std::fabs(down.y) < kFlatShare * std::fabs(down.x);
    if (flatY && (stoppedX || risesBeyond(at.low, down.x, {1, 0})))
        down.y = std::fabs(down.x) * cheaperSide(at.low, {0, 1});
    if (flatX && (stoppedY || risesBeyond(at.low, down.y, {0, 1})))
        down.x = std::fabs(down.y) * cheaperSide(at.low, {1, 0});
    if (stoppedX) down.x = 0.0;
    if (stoppedY) down.y = 0.0;
    down = normalized(down);
    // A point that is nearer to such a side than to the reached cells is too near to a wall and also led away
    // from it.
    if (!left || !right) down.x += left ? std::min(0.0, 0.5 - at.fx) : std::max(0.0, 0.5 - at.fx);
    if (!below || !above) down.y += below ? std::min(0.0, 0.5 - at.fy) : std::max(0.0, 0.5 - at.fy);
    return normalized(down);
}

// The cheaper of the two cells that lie `along` cells from the lower side of a square of centres on `axis`.
float CostField::cheapestAcross(Cell low, Cell axis, std::int32_t along) const {
    const Cell c{low.x + along * axis.x, low.y + along * axis.y};
    return std::min(value(c), value({c.x + axis.y, c.y + axis.x}));
}

// True where the cost falls along `axis`, in the direction of `sign`, up to the edge of the square of centres
// only, and rises beyond it. The source is the only true minimum: near it the answer is false.
bool CostField::risesBeyond(Cell low, double sign, Cell axis) const {
    const double sourceReach = uniformRadius_ + 3.0 * grid_.cell;
    if (lengthSquared(grid_.centre(low) - source_) <= sourceReach * sourceReach) return false;
    const float edge = cheapestAcross(low, axis, sign > 0.0 ? 1 : 0);
    const float beyond = cheapestAcross(low, axis, sign > 0.0 ? 2 : -1);
    return beyond < kUnreachableCost && beyond > edge;
}

// The side of a square of centres along `axis` beyond which the cells are cheaper: 1 or -1, 1 where they tie;
// 0 where neither side is reached.
double CostField::cheaperSide(Cell low, Cell axis) const {
    const float ahead = cheapestAcross(low, axis, 2);
    const float behind = cheapestAcross(low, axis, -1);
    if (!(ahead < kUnreachableCost) && !(behind < kUnreachableCost)) return 0.0;
    return ahead <= behind ? 1.0 : -1.0;
}

// Direction to a reached cell near by: the nearer the better, of equally near cells the cheaper one.
Vec2 CostField::towardsReached(Vec2 p) const {
    const Cell middle = grid_.nearestCell(p);
    double best = std::numeric_limits<double>::infinity();
    Vec2 to = p;
    for (std::int32_t y = middle.y - kSearchReach; y <= middle.y + kSearchReach; ++y) {
        for (std::int32_t x = middle.x - kSearchReach; x <= middle.x + kSearchReach; ++x) {
            const float cost = value({x, y});
            if (!(cost < kUnreachableCost)) continue;
            const double away = distance(grid_.centre({x, y}), p);
            const double score = 4.0 * away + cost;
            if (away > 1e-9 && score < best) {
                best = score;
                to = grid_.centre({x, y});
            }
        }
    }
    return normalized(to - p);
}

}  // namespace muster
