// Queries of the static ground along lines.
#include <algorithm>
#include <cmath>

#include "base/bilinear.h"
#include "engine/fields/cost/static_ground.h"

namespace muster {
namespace {

// Depth to which a line of sight may enter walls, because of rounding [m].
constexpr double kSightPenetration = 0.02;
// Least step of sphere tracing [m].
constexpr double kLeastStep = 0.12;
// Clearance below which values are interpolated, which is slower but more precise [m].
constexpr double kInterpolatedClearance = 0.75;
static_assert(kInterpolatedClearance + kLeastStep < GapIndex::kReach);

}  // namespace

// Bounds and steps of the squares of four neighbouring cells, prepared for many readings.
struct StaticGround::Squares {
    Vec2 most;  // Bounds as bilinearPoint() takes them.
    Cell last;
    std::int32_t right, up;  // Steps to the next column and row; 0 where there is none.

    explicit Squares(const Grid& grid)
        : most{grid.width - 1.0, grid.height - 1.0},
          last{std::max(0, grid.width - 2), std::max(0, grid.height - 2)},
          right(grid.width > 1 ? 1 : 0),
          up(grid.height > 1 ? 1 : 0) {}
};

template <class Clearance>
double StaticGround::interpolate(const Squares& squares, Vec2 inCells, const Clearance& clearance) const {
    const BilinearPoint at = bilinearPoint(inCells.x, inCells.y, squares.most, squares.last);
    const Cell low = at.low, high{low.x + squares.right, low.y + squares.up};
    const std::int32_t below = low.y * grid_.width, above = high.y * grid_.width;
    return interpolateBilinear(clearance(low, below + low.x), clearance(Cell{high.x, low.y}, below + high.x),
                               clearance(Cell{low.x, high.y}, above + low.x), clearance(high, above + high.x),
                               at.fx, at.fy);
}

double StaticGround::interpolatedClearance(Vec2 p) const {
    const Vec2 at = inCells(p);
    if (!holds(at)) return -1.0;
    return interpolate(Squares(grid_), at,
                       [&](Cell c, std::int32_t cell) { return uniformClearanceOf(c, cell); });
}

double StaticGround::lineCost(Vec2 a, Vec2 b) const {
    if (uniform()) return lowest_ * distance(a, b);
    constexpr int kSamples = 8;
    double sum = 0.0;
    for (int k = 0; k < kSamples; ++k) sum += unitCost(a + (b - a) * ((k + 0.5) / kSamples));
    return sum / kSamples * distance(a, b);
}

bool StaticGround::lineOfSight(Vec2 a, Vec2 b, double length) const {
    if (open_) return true;
    // A path that leaves slow ground and returns may be faster, unless both ends lie deep in that ground.
    if (!uniform() && unitCost(b) > lowest_)
        return unitCost(a) == unitCost(b) && uniformClearance(a) + uniformClearance(b) >= length;
    if (uniform())
        return traceSpheres(a, b, length,
                            [&](Cell c, std::int32_t cell) { return extendedClearance(c, cell); });
    return traceSpheres(a, b, length, [&](Cell c, std::int32_t cell) { return uniformClearanceOf(c, cell); });
}

bool StaticGround::collisionFree(Vec2 a, Vec2 b) const {
    return open_ || traceSpheres(a, b, distance(a, b),
                                 [&](Cell c, std::int32_t cell) { return extendedClearance(c, cell); });
}

// Sphere tracing (Hart 1996): steps along the line as far as the clearance at each point reaches.
template <class Clearance>
bool StaticGround::traceSpheres(Vec2 a, Vec2 b, double length, const Clearance& clearance) const {
    // No wall fits between two points that are so near to each other. They may stand in a door so narrow that
    // none of its cells is free.
    if (length <= radius_) return gaps_.empty() || !grid_.box().contains(a) || !gaps_.crossed(a, b, a);
    const Vec2 from = inCells(a), to = inCells(b);
    const auto lowerBound = [&](Vec2 at) {
        if (!holds(at)) return -1.0;
        const Cell cell = cellAt(at);
        return static_cast<double>(clearance(cell, grid_.index(cell))) - halfDiagonal_;
    };
    // The disc round the end needs no steps.
    const double last = length - std::max(lowerBound(to), 0.0);
    double free = lowerBound(from);
    if (free >= kInterpolatedClearance && free >= last) return true;
    const Vec2 direction = (b - a) / length;
    const Squares squares(grid_);
    for (double at = 0.0; at < last;) {
        const Vec2 p = inCells(a + direction * at);
        free = lowerBound(p);
        if (free < kInterpolatedClearance) {
            if (!holds(p)) return false;
            free = interpolate(squares, p, clearance);
            // A step leads at most kInterpolatedClearance onward, and no gap is nearer to where a larger one
            // begins.
            if (!gaps_.empty() && gaps_.crossed(a, b, a + direction * at)) return false;
        }
        if (free < -kSightPenetration) return false;
        at += std::max(free, kLeastStep);
    }
    return true;
}

}  // namespace muster
