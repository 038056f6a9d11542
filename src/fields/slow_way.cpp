#include "fields/slow_way.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kStep = 0.125;          // Between two looks at the ground [m].
constexpr std::int32_t kMostLooks = 40;  // Along a line.
constexpr double kBends[] = {0.3, 0.7, 1.3, 2.2};  // From the line, to both sides [m].

struct Line {
    double cost = 0.0;
    double changes = -1.0;  // The share at which the ground changes most; negative where it does not.
};

Line along(const StaticGround& ground, Vec2 a, Vec2 b) {
    const double whole = distance(a, b);
    const std::int32_t looks = std::min(kMostLooks, static_cast<std::int32_t>(whole / kStep) + 1);
    const double share = 1.0 / looks;
    Line line;
    float last = 0.0f;
    float most = 0.0f;
    for (std::int32_t k = 0; k < looks; ++k) {
        const float unit = ground.unit(a + (b - a) * ((k + 0.5) * share));
        line.cost += unit;
        const float step = k > 0 ? std::fabs(unit - last) : 0.0f;
        if (step > most) line.changes = k * share;
        most = std::max(most, step);
        last = unit;
    }
    line.cost *= share * whole;
    return line;
}

}  // namespace

SlowWay slowWay(const StaticGround& ground, Vec2 from, Vec2 to) {
    const Line straight = along(ground, from, to);
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
            const double first = along(ground, from, by).cost;
            if (first + lowest * length2 >= best.cost) continue;
            const double cost = first + along(ground, by, to).cost;
            if (cost < best.cost && ground.clear(from, by) && ground.clear(by, to)) best = {cost, by};
        }
    }
    return best;
}

}  // namespace muster
