#include "engine/fields/geodesics/one_vertex_paths.h"

#include <algorithm>

namespace muster {
namespace {

// Relative dynamic cost along the straight line from which a detour is sought [m].
constexpr double kDetourThreshold = 0.25;
// Distances of the vertex from the line, to either side [m].
constexpr double kDetourOffsets[] = {0.4, 0.8, 1.2, 1.7, 2.3, 3.0};

/// A path over one vertex.
struct Detour {
    Vec2 vertex;         // Vertex of the path [m].
    double extra = 0.0;  // Length beyond the straight line [m].
};

// The most promising vertex next to `middle`, if the dynamic cost fell everywhere as it does there. It stays
// `middle` where none is better than the straight line.
Detour bestDetour(const DynamicCost& dynamicCost, Vec2 a, Vec2 b, double line, double fraction, Vec2 middle,
                  double straight, double worst) {
    const Vec2 normal = perpendicular((b - a) / line);
    double least = straight;
    Detour best{middle};
    for (const double offset : kDetourOffsets) {
        const double extra = length({fraction * line, offset}) + length({(1.0 - fraction) * line, offset}) -
                             line;
        if (extra >= least) break;
        for (const Vec2 p : {middle + normal * offset, middle - normal * offset}) {
            const double estimate = extra + straight * (dynamicCost.movingCostAt(p) / worst);
            if (!(estimate < least)) continue;
            least = estimate;
            best = {p, extra};
        }
    }
    return best;
}

}  // namespace

double dynamicCostBetween(const StaticGround& ground, const DynamicCost& dynamicCost, Vec2 a, Vec2 b,
                          double line) {
    if (!dynamicCost.meets(a, b)) return 0.0;
    const auto [cost, fraction] = dynamicCost.costAndCentroid(ground, a, b, line);
    if (!(cost > 0.0)) return cost;
    const double unitCost = ground.unitCost(a);
    const double straight = cost / unitCost;
    if (straight < kDetourThreshold) return cost;
    if (fraction < 0.0) return cost;
    const Vec2 middle = lerp(a, b, fraction);
    const double worst = dynamicCost.movingCostAt(middle);
    if (!(worst > 0.0)) return cost;
    const auto [vertex, extra] = bestDetour(dynamicCost, a, b, line, fraction, middle, straight, worst);
    if (vertex == middle || !ground.lineOfSight(a, vertex)) return cost;
    const double toVertex = extra + dynamicCost.relativeAlong(a, vertex);
    // Mostly the first part alone decides.
    if (unitCost * toVertex >= cost && !dynamicCost.hasNegativeCost()) return cost;
    if (!ground.lineOfSight(vertex, b)) return cost;
    return std::min(cost, unitCost * (toVertex + dynamicCost.relativeAlong(vertex, b)));
}

}  // namespace muster
