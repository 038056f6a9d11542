// Groups without a formation: while members go to areas nobody has a place, so that joining and leaving costs
// next to nothing (docs/method/goals.md).
#pragma once

#include "engine/state/world_state.h"

namespace muster {

/// Takes the formation of a group, which keeps its definition; no background work may be running. Nobody has
/// a place from now on.
void dissolveFormation(WorldState& state, Group& group);
/// Gives a group that has none its formation again, where its people are; places begin where those stand who
/// get them. No background work may be running.
void formUp(WorldState& state, Group& group);
/// True for a group that has members and no formation.
inline bool isBare(const Group& group) {
    return group.places.positions().empty() && !group.members.empty();
}
/// Adds a character at a free point [m] to a group without formation; its index.
std::size_t joinBare(WorldState& state, Group& group, Vec2 position, const Body& body);

}  // namespace muster
