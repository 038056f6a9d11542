#include "engine/systems/orders/march_pace.h"

#include <algorithm>

#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kLeastLag = 0.6;  // Lag up to which the mesh does not wait [m].
constexpr double kMostLag = 5.0;   // Lag from which on the mesh stands [m].
// Distance of a place from the formation beyond which the mesh does not wait for it [m].
constexpr double kMostPlaceShift = 1.5;

}  // namespace

// The pace that the lag of the last member allows, without a few stragglers, members that are stuck or have
// not set out yet, and members whose places had to leave the formation.
double MarchPace::of(const WorldState& state, const Group& group) {
    if (!state.parameters.opposing.enabled) return 1.0;
    const Characters& c = state.characters;
    const std::uint32_t patience = stepsIn(state, kStuckTime);
    lags_.clear();
    for (const std::int32_t i : group.members) {
        if (c.place[i] < 0 || c.driver[i] != Driver::Muster || !c.hasSetOut(i, state.stepCount)) continue;
        const Vec2 target = group.places.reachableTargets()[c.place[i]];
        const double lag = distance(c.position[i], target);
        if (lag > kLeastLag &&
            distance(target, group.places.targetsWithinReach()[c.place[i]]) > kMostPlaceShift)
            continue;
        if (lag <= kLeastLag || state.stepCount - c.walk[i].movedAt < patience) lags_.push_back(lag);
    }
    if (lags_.empty()) return 1.0;
    const auto at = lags_.end() - 1 - static_cast<std::ptrdiff_t>(lags_.size() / kStragglers);
    std::nth_element(lags_.begin(), at, lags_.end());
    return std::clamp((kMostLag - *at) / (kMostLag - kLeastLag), 0.0, 1.0);
}

}  // namespace muster
