#include "engine/systems/orders/march_pace.h"

#include <algorithm>

#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kLagFree = 0.6;    // The mesh does not wait for lags below [m]...
constexpr double kLagMost = 5.0;    // ... and stands for those above [m].
constexpr double kLagShare = 0.95;  // Of the group, whose lag counts.
constexpr double kShifted = 1.5;    // Places so far off the formation are not waited for [m].
constexpr double kWaits = 0.2;      // At a pace below it waits.
constexpr double kWaitsFor = 10.0;  // From here on, and to twice that, it begins to go on [s]...
constexpr double kCreeps = 0.3;     // ... at this pace.

/// A march that has waited for long creeps on, so that no order lasts for ever.
double patientPace(March& march, double pace, double dt) {
    march.waited = pace < kWaits ? march.waited + dt : std::max(0.0, march.waited - 2.0 * dt);
    return std::max(pace, kCreeps * std::clamp((march.waited - kWaitsFor) / kWaitsFor, 0.0, 1.0));
}

}  // namespace

double MarchPace::of(const WorldState& state, Group& group) {
    return patientPace(group.orders.march, byLags(state, group), state.parameters.stepTime);
}

// By the lag of the last but a few, without those who do not get on, and those whose places had to leave the
// formation.
double MarchPace::byLags(const WorldState& state, const Group& group) {
    if (!state.parameters.opposing.enabled) return 1.0;
    const Characters& c = state.characters;
    const std::uint32_t patience = stepsIn(state, kStuckFor);
    lags_.clear();
    for (const std::int32_t i : group.members) {
        if (c.place[i] < 0 || c.driver[i] != Driver::Muster) continue;
        const Vec2 target = group.places.reachableTargets()[c.place[i]];
        const double lag = distance(c.position[i], target);
        if (lag > kLagFree && distance(target, group.places.targetsWithinReach()[c.place[i]]) > kShifted)
            continue;
        if (lag <= kLagFree || state.stepCount - c.walk[i].movedAt < patience) lags_.push_back(lag);
    }
    if (lags_.empty()) return 1.0;
    const auto at = lags_.begin() +
                    static_cast<std::ptrdiff_t>(kLagShare * static_cast<double>(lags_.size() - 1));
    std::nth_element(lags_.begin(), at, lags_.end());
    return std::clamp((kLagMost - *at) / (kLagMost - kLagFree), 0.0, 1.0);
}

}  // namespace muster
