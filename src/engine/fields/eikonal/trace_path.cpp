#include "engine/fields/eikonal/cost_field.h"

#include <cmath>

#include "muster/assert.h"

namespace muster {

bool tracePath(const CostField& field, Vec2 from, double step, std::vector<Vec2>& path) {
    MUSTER_ASSERT(step > 0.0);
    path.clear();
    double best = field.cost(from);
    if (!std::isfinite(best)) return false;
    path.push_back(from);
    Vec2 p = from;
    // Number of steps within which the cost has to reach a new minimum; otherwise the path circles.
    constexpr int kMaxIdleSteps = 16;
    int idle = 0;
    const double most = 1000.0 + 4.0 * field.acceptedCount() * (1.0 + field.grid().cell / step);
    while (idle < kMaxIdleSteps && static_cast<double>(path.size()) < most) {
        if (distance(p, field.source()) <= step) {
            path.push_back(field.source());
            return true;
        }
        const Vec2 here = field.direction(p);
        const Vec2 middle = field.direction(p + here * (0.5 * step));
        const Vec2 direction = std::isfinite(field.cost(p + middle * step)) && !(middle == Vec2{}) ? middle
                                                                                                   : here;
        if (direction == Vec2{}) return false;
        p += direction * step;
        path.push_back(p);
        const double cost = field.cost(p);
        idle = cost < best * (1.0 - 1e-9) ? 0 : idle + 1;
        best = cost < best ? cost : best;
    }
    return false;
}

double pathLength(const std::vector<Vec2>& path) {
    double sum = 0.0;
    for (std::size_t k = 1; k < path.size(); ++k) sum += distance(path[k - 1], path[k]);
    return sum;
}

}  // namespace muster
