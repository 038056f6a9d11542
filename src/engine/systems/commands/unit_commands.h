// What the commands of units change: who belongs to which group, and what they are.
#pragma once

#include <vector>

#include "engine/state/world_state.h"
#include "muster/event.h"
#include "muster/command_kinds.h"

namespace muster {

// Each fails, changing nothing, with NotFound where somebody does not exist, else with InvalidArgument or
// LimitExceeded. No background work may be running.

/// Characters join a group.
/// Lets one character join a group at a free point [m]; its index. No background work may be running.
std::int32_t joinOne(WorldState& state, Group& group, Vec2 position, const Body& body);
Status addCharacters(WorldState& state, const AddCharacters& command, std::vector<Event>& events);
/// Characters leave the world.
Status removeCharacters(WorldState& state, const RemoveCharacters& command, std::vector<Event>& events);
/// Characters change groups.
Status transferCharacters(WorldState& state, const TransferCharacters& command, std::vector<Event>& events);
/// Divides a group.
Status splitGroup(WorldState& state, const SplitGroup& command, std::vector<Event>& events);
/// Joins groups.
Status mergeGroups(WorldState& state, const MergeGroups& command, std::vector<Event>& events);

}  // namespace muster
