#include "engine/steering/cohesion.h"

#include <algorithm>
#include <cmath>

#include "engine/steering/character_arrays.h"

namespace muster {

void Cohesion::setPaces(double cohesion, const CrowdBodies& bodies, const Characters& now,
                        std::span<const std::int32_t> members, std::span<double> pace) {
    left_.clear();
    double slowest = 0.0;
    const auto counts = [&](std::int32_t i) {
        const bool goes = now.place[i] >= 0 || (!now.goal.empty() && now.goal[i] != 0);
        return goes && std::isfinite(now.cost[i]) && !bodies.isFixed(i);
    };
    for (const std::int32_t i : members) {
        if (!counts(i)) continue;
        const double own = bodies.maxSpeed(i);
        slowest = left_.empty() ? own : std::min(slowest, own);
        left_.push_back(now.cost[i]);
    }
    if (left_.empty()) return;
    const auto last = left_.begin() + static_cast<std::ptrdiff_t>((left_.size() - 1) * 9 / 10);
    std::nth_element(left_.begin(), last, left_.end());
    for (const std::int32_t i : members) {
        if (!counts(i)) continue;
        const double ahead = *last - now.cost[i], own = bodies.maxSpeed(i);
        const double share = std::clamp(kCatchUpFactor - kPacePerMetre * ahead, kLeastPace, kCatchUpFactor);
        pace[i] = 1.0 - cohesion + cohesion * std::min(1.0, slowest * share / own);
    }
}

}  // namespace muster
