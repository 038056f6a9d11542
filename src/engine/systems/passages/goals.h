// The places of a group in the near future.
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// The mean of a sample of a group's goals [m].
Vec2 meanGoal(const Group& group);
/// The expected position of a place [m].
inline Vec2 goalOf(const Group& group, std::int32_t place) {
    return group.places.reachableTargets()[place] + group.foreseen;
}
/// Foresees the goals of a group: goals that have moved for a while will go on for a while, so that agents
/// which will have to wait set out now. Call once before each choice of ways.
void foresee(const WorldState& state, Group& group);
/// Cost that is walked in a second [m].
inline double metresPerSecond(const Parameters& p) {
    return (p.cost.alpha + p.cost.beta) * p.character.maxSpeed;
}

}  // namespace muster
