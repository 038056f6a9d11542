#include "engine/systems/orders/march_pace.h"

#include <algorithm>

#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kLagFree = 0.6;  // The mesh does not wait for lags below [m]...
constexpr double kLagMost = 5.0;  // ... and stands for those above [m].
constexpr double kShifted = 1.5;  // Places so far off the formation are not waited for [m].

}  // namespace

// By the lag of the last but a few, without those who do not get on or have not set out yet, and those whose
// places had to leave the formation.
double MarchPace::of(const WorldState& state, const Group& group) {
    if (!state.parameters.opposing.enabled) return 1.0;
    const Characters& c = state.characters;
    const std::uint32_t patience = stepsIn(state, kStuckFor);
    lags_.clear();
    for (const std::int32_t i : group.members) {
        if (c.place[i] < 0 || c.driver[i] != Driver::Muster || !c.hasSetOut(i, state.stepCount)) continue;
        const Vec2 target = group.places.reachableTargets()[c.place[i]];
        const double lag = distance(c.position[i], target);
        if (lag > kLagFree && distance(target, group.places.targetsWithinReach()[c.place[i]]) > kShifted)
            continue;
        if (lag <= kLagFree || state.stepCount - c.walk[i].movedAt < patience) lags_.push_back(lag);
    }
    if (lags_.empty()) return 1.0;
    const auto at = lags_.end() - 1 - static_cast<std::ptrdiff_t>(lags_.size() / kStragglers);
    std::nth_element(lags_.begin(), at, lags_.end());
    return std::clamp((kLagMost - *at) / (kLagMost - kLagFree), 0.0, 1.0);
}

}  // namespace muster
