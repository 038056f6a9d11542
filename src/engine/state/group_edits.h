// Changes of groups and of their characters: joining, leaving, another formation.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engine/state/world_state.h"
#include "muster/status.h"

namespace muster {

/// A plan by `plan.solver`; the only place that knows which solvers there are.
std::unique_ptr<Plan> makePlan(const Parameters& parameters);
/// Gives every group a new plan, for another solver: all are planned again in the next step, with the places
/// that characters have as incumbents. No background work may be running.
void exchangePlans(WorldState& state);

/// Takes the places of a group's members, and what was planned for them.
void leavePlaces(WorldState& state, Group& group);

/// Adds a character, which stands still, to the arrays; its index. The members of its group are not changed.
std::size_t addCharacter(WorldState& state, const Group& group, std::uint32_t groupIndex, Vec2 position,
                         const Body& body);
/// Adds a group and its characters. Fails, changing nothing, where the definition is bad or the world would
/// hold too many groups or characters.
Status addGroup(WorldState& state, const GroupDef& def);
/// Removes a group and its characters. No background work may be running.
void removeGroup(WorldState& state, std::size_t index);
/// Puts a group elsewhere at once: mesh, places and characters, who stand still at their places. Fails,
/// changing nothing, where the mesh cannot stand there.
Status standAt(WorldState& state, Group& group, const Pose& pose);
/// Gives a group another formation with `count` places. New places appear at once where they can be reached;
/// they are assigned afresh. Fails, changing nothing, where the formation cannot be made.
Status changeFormation(WorldState& state, Group& group, const FormationDef& def, std::int32_t count);
/// Gives a group another formation where its mesh stands; its places go on from where they are, at once.
/// Fails, changing nothing, where the formation cannot be made. No background work may be running.
Status reformGroup(WorldState& state, Group& group, const FormationDef& def);
/// Adds characters to a group near given positions [m], with bodies one for each, one for all, or none, where
/// each is drawn (draw_person.h). They have no places yet.
void joinCharacters(WorldState& state, const Group& group, std::span<const Vec2> positions,
                    std::span<const Body> bodies);
/// Removes the characters that are marked by 1, one mark for each.
void removeCharacters(Characters& characters, std::span<const std::uint8_t> leaves);
/// Adds characters behind the mesh, or removes those with the highest ids, until the group has `count`.
void setCount(WorldState& state, Group& group, std::int32_t count);

}  // namespace muster
