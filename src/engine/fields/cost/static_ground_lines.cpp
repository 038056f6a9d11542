// Queries of the static ground along lines.
#include <algorithm>
#include <cmath>

#include "base/bilinear.h"
#include "engine/fields/cost/static_ground.h"

namespace muster {
namespace {

// Lines of sight may enter walls by this much, because of rounding [m].
constexpr double kPenetration = 0.02;
// Least step of sphere tracing [m].
constexpr double kLeastStep = 0.12;
// Clearances below this are interpolated, which is slower but more precise [m].
constexpr double kInterpolated = 0.75;
static_assert(kInterpolated + kLeastStep < GapIndex::kReach);

}  // namespace

template <class Clearance>
double StaticGround::interpolate(Vec2 inCells, const Clearance& clearance) const {
    const BilinearPoint at = bilinearPoint(grid_, inCells.x, inCells.y);
    const std::int32_t right = grid_.width > 1 ? 1 : 0;
    const std::int32_t up = grid_.height > 1 ? 1 : 0;
    const Cell low = at.low;
    return interpolateBilinear(clearance(low), clearance(Cell{low.x + right, low.y}),
                               clearance(Cell{low.x, low.y + up}), clearance(Cell{low.x + right, low.y + up}),
                               at.fx, at.fy);
}

double StaticGround::interpolatedClearance(Vec2 p) const {
    const Vec2 at = inCells(p);
    return holds(at) ? interpolate(at, [&](Cell c) { return uniformClearanceOf(c); }) : -1.0;
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
        return traceSpheres(a, b, length, [&](Cell c) { return extendedClearance(c, grid_.index(c)); });
    return traceSpheres(a, b, length, [&](Cell c) { return uniformClearanceOf(c); });
}

bool StaticGround::collisionFree(Vec2 a, Vec2 b) const {
    return open_ ||
           traceSpheres(a, b, distance(a, b), [&](Cell c) { return extendedClearance(c, grid_.index(c)); });
}

// Sphere tracing (Hart 1996): steps along the line as far as the clearance at each point reaches.
template <class Clearance>
bool StaticGround::traceSpheres(Vec2 a, Vec2 b, double length, const Clearance& clearance) const {
    // No wall fits between two points so near to each other. They may stand in a door so narrow that no cell
    // of it is free.
    if (length <= radius_) return gaps_.empty() || !grid_.box().contains(a) || !gaps_.crossed(a, b, a);
    const Vec2 from = inCells(a), to = inCells(b);
    const auto lowerBound = [&](Vec2 at) {
        return holds(at) ? static_cast<double>(clearance(cellAt(at))) - halfDiagonal_ : -1.0;
    };
    // The disc round the end needs no steps.
    const double last = length - std::max(lowerBound(to), 0.0);
    double free = lowerBound(from);
    if (free >= kInterpolated && free >= last) return true;
    const Vec2 direction = (b - a) / length;
    for (double at = 0.0; at < last;) {
        const Vec2 p = inCells(a + direction * at);
        free = lowerBound(p);
        if (free < kInterpolated) {
            if (!holds(p)) return false;
            free = interpolate(p, clearance);
            // A step leads at most kInterpolated onward, and no gap is nearer to where a larger one begins.
            if (!gaps_.empty() && gaps_.crossed(a, b, a + direction * at)) return false;
        }
        if (free < -kPenetration) return false;
        at += std::max(free, kLeastStep);
    }
    return true;
}

}  // namespace muster
