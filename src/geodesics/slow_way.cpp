#include "geodesics/slow_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kStep = 0.25;                     // Between two looks at the ground [m].
constexpr std::int32_t kMostLooks = 32;            // Along a line.
constexpr std::int32_t kHalvings = 3;              // Where the ground changes between two looks.
constexpr double kBends[] = {0.3, 0.7, 1.3, 2.2};  // From the line, to both sides [m].

struct Line {
    double cost = 0.0;
    double changes = -1.0;  // The share at which the ground changes most; negative where it does not.
};

// Where on the line, between two shares, the ground changes from one unit to another.
double changeBetween(const StaticGround& ground, Vec2 a, Vec2 way, double low, double high, float unit) {
    for (std::int32_t k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (low + high);
        (ground.unitCost(a + way * middle) == unit ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// Not looked at to its end where it costs more than `most`.
Line along(const StaticGround& ground, Vec2 a, Vec2 b, double most) {
    const Vec2 way = b - a;
    const double whole = length(way);
    const std::int32_t looks = std::min(kMostLooks, static_cast<std::int32_t>(whole / kStep) + 1);
    const double share = 1.0 / looks;
    Line line;
    float last = ground.unitCost(a);
    float largest = 0.0f;
    double since = 0.0;  // The share from which the ground costs `last`.
    for (std::int32_t k = 1; k <= looks && line.cost <= most; ++k) {
        const float unit = ground.unitCost(a + way * (k * share));
        if (unit == last) continue;
        const double change = changeBetween(ground, a, way, (k - 1) * share, k * share, last);
        line.cost += last * (change - since) * whole;
        if (std::fabs(unit - last) > largest) line.changes = change;
        largest = std::max(largest, std::fabs(unit - last));
        since = change;
        last = unit;
    }
    line.cost += last * (1.0 - since) * whole;
    return line;
}

}  // namespace

SlowWay slowWay(const StaticGround& ground, Vec2 from, Vec2 to) {
    const Line straight = along(ground, from, to, kInfinite);
    SlowWay best{straight.cost, to};
    if (straight.changes < 0.0) return best;
    const double whole = distance(from, to);
    const Vec2 bends = lerp(from, to, straight.changes);
    const Vec2 aside = perpendicular((to - from) / whole);
    const double lowest = ground.fine().lowest;
    for (const double bend : kBends) {
        const double length1 = length({straight.changes * whole, bend});
        const double length2 = length({(1.0 - straight.changes) * whole, bend});
        if (lowest * (length1 + length2) >= best.cost) break;
        for (const Vec2 by : {bends + aside * bend, bends - aside * bend}) {
            const double first = along(ground, from, by, best.cost).cost;
            if (first + lowest * length2 >= best.cost) continue;
            const double cost = first + along(ground, by, to, best.cost - first).cost;
            if (cost < best.cost && ground.collisionFree(from, by) && ground.collisionFree(by, to))
                best = {cost, by};
        }
    }
    return best;
}

}  // namespace muster
