// Where the places of a group will be soon.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// The mean of some goals of a group, which stands for all [m].
Vec2 meanGoal(const Group& group);
/// Where a place will be soon [m].
inline Vec2 goalOf(const Group& group, std::int32_t place) {
    return group.places.reachableTargets()[place] + group.foreseen;
}
/// Goals that have moved for a while will go on for a while: who has to wait then should set out now. Call
/// once whenever somebody looks for ways.
void foresee(const WorldState& state, Group& group);
/// Cost of what is walked in a second [m].
inline double metresPerSecond(const Parameters& p) {
    return (p.cost.alpha + p.cost.beta) * p.character.maxSpeed;
}

}  // namespace muster
