#include "geodesics/crowd_detour.h"

#include <algorithm>

namespace muster {
namespace {

constexpr double kWorthBending = 0.25;  // Excess that is borne before a bent way is sought [m].
constexpr double kBends[] = {0.4, 0.8, 1.2, 1.7, 2.3, 3.0};  // From the line, to both sides [m].

}  // namespace

double excessBetween(const StaticGround& ground, const DynamicCost& excess, Vec2 a, Vec2 b, double line) {
    const double cost = excess.costAlong(ground, a, b, line);
    if (!(cost > 0.0)) return cost;
    const double unit = ground.unitCost(a);
    const double straight = cost / unit;
    if (straight < kWorthBending) return cost;
    const double share = excess.movingCostCentroid(a, b, line);
    if (share < 0.0) return cost;
    const Vec2 middle = lerp(a, b, share);
    const Vec2 aside = perpendicular((b - a) / line);
    const double worst = excess.movingCostAt(middle);
    if (!(worst > 0.0)) return cost;
    // The most promising of the bends: as if the excess fell everywhere as it does there.
    double least = straight;
    double longer = 0.0;
    Vec2 by = middle;
    for (const double bend : kBends) {
        const double more = length({share * line, bend}) + length({(1.0 - share) * line, bend}) - line;
        if (more >= least) break;
        for (const Vec2 p : {middle + aside * bend, middle - aside * bend}) {
            const double guess = more + straight * (excess.movingCostAt(p) / worst);
            if (!(guess < least)) continue;
            least = guess;
            longer = more;
            by = p;
        }
    }
    if (by == middle || !ground.lineOfSight(a, by) || !ground.lineOfSight(by, b)) return cost;
    return std::min(cost, unit * (longer + excess.relativeAlong(a, by) + excess.relativeAlong(by, b)));
}

}  // namespace muster
