#include "engine/orders/march.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/orders/turning.h"

namespace muster {

double marchTime(const MarchDef& def, std::span<const Vec2> way, Vec2 front, std::optional<double> facing) {
    double sum = 0.0, turns = 0.0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const Vec2 ahead = normalized(way[k] - way[k - 1], front);
        sum += distance(way[k - 1], way[k]);
        if (def.turn == Turn::Keep) continue;
        double error = std::fabs(angleBetween(front, ahead));
        if (def.turn == Turn::Reverse) error = std::min(error, kPi - error);
        turns += error;
        front = ahead;
    }
    if (facing) turns += std::fabs(angleBetween(front, {cosine(*facing), sine(*facing)}));
    const double speed = std::max(def.speed, 1e-9);
    return (sum + turns * def.reach) / speed + speed / def.acceleration;
}

}  // namespace muster
