#include "engine/fields/geodesics/one_vertex_paths.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr double kSampleSpacing = 0.25;   // Distance between two samples of the ground along a line [m].
constexpr std::int32_t kMaxSamples = 32;  // Greatest number of samples of one line.
// Number of bisections that locate a change of the ground between two samples.
constexpr std::int32_t kBisections = 3;
// Distances of the vertex from the line, to either side [m].
constexpr double kRefractionOffsets[] = {0.3, 0.7, 1.3, 2.2};

/// The cost along a line, and where the ground changes.
struct LineCost {
    double cost = 0.0;  // Cost along the line [m].
    // Fraction of the line at which the unit cost changes most; negative where it does not change.
    double largestChange = -1.0;
};

// The fraction of a line, between two others, at which the ground changes from one unit cost to another.
double bisectChange(const StaticGround& ground, Vec2 a, Vec2 line, double low, double high, float unitCost) {
    for (std::int32_t k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (low + high);
        (ground.unitCost(a + line * middle) == unitCost ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// Sampling stops where the cost exceeds `limit`.
LineCost costOfLine(const StaticGround& ground, Vec2 a, Vec2 b, double limit) {
    const Vec2 line = b - a;
    const double whole = length(line);
    const std::int32_t samples = std::min(kMaxSamples, static_cast<std::int32_t>(whole / kSampleSpacing) + 1);
    const double share = 1.0 / samples;
    LineCost result;
    float last = ground.unitCost(a);
    float largest = 0.0f;
    double since = 0.0;  // The fraction from which the unit cost is `last`.
    for (std::int32_t k = 1; k <= samples && result.cost <= limit; ++k) {
        const float unitCost = ground.unitCost(a + line * (k * share));
        if (unitCost == last) continue;
        const double change = bisectChange(ground, a, line, (k - 1) * share, k * share, last);
        result.cost += last * (change - since) * whole;
        if (std::fabs(unitCost - last) > largest) result.largestChange = change;
        largest = std::max(largest, std::fabs(unitCost - last));
        since = change;
        last = unitCost;
    }
    result.cost += last * (1.0 - since) * whole;
    return result;
}

}  // namespace

RefractedPath refractedPath(const StaticGround& ground, Vec2 from, Vec2 to) {
    const LineCost straight = costOfLine(ground, from, to, kInfiniteCost);
    RefractedPath best{straight.cost, to};
    if (straight.largestChange < 0.0) return best;
    const double whole = distance(from, to);
    const Vec2 change = lerp(from, to, straight.largestChange);
    const Vec2 normal = perpendicular((to - from) / whole);
    const double lowest = ground.lowestUnitCost();
    for (const double offset : kRefractionOffsets) {
        const double length1 = length({straight.largestChange * whole, offset});
        const double length2 = length({(1.0 - straight.largestChange) * whole, offset});
        if (lowest * (length1 + length2) >= best.cost) break;
        for (const Vec2 vertex : {change + normal * offset, change - normal * offset}) {
            const double first = costOfLine(ground, from, vertex, best.cost).cost;
            if (first + lowest * length2 >= best.cost) continue;
            const double cost = first + costOfLine(ground, vertex, to, best.cost - first).cost;
            if (cost < best.cost && ground.collisionFree(from, vertex) && ground.collisionFree(vertex, to))
                best = {cost, vertex};
        }
    }
    return best;
}

}  // namespace muster
