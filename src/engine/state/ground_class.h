// Classes of ground: planning for bodies of several sizes (SPEC A2).
#pragma once

#include <cstdint>

#include "base/parallel.h"
#include "engine/state/world_state.h"

namespace muster {

/// The class of ground for a body: 0 for one of the usual radius [m], one more for each factor of the fourth
/// root of 2 above it. All bodies of a class fit where its largest fits.
std::int32_t groundClassFor(double usual, double radius);
/// The largest radius of a class [m].
double groundRadius(double usual, std::int32_t groundClass);
/// The class of ground for a group in which all can get to where they are to go: that of its largest member.
std::int32_t groundClassFor(const WorldState& state, const Group& group);
/// True where a member of the group fits on the ground of its class. Who does not stays behind.
bool fitsGround(const WorldState& state, const Group& group, std::int32_t character);
/// Number of members who do not fit on the ground of the group's class.
std::int32_t tooLargeFor(const WorldState& state, const Group& group);
/// Mean radius of a group's members who fit on its ground [m]; the usual one where there are none.
double meanRadius(const WorldState& state, const Group& group);
/// How the places of a group travel: with room for its members.
PlaceDef placeDefOf(const WorldState& state, const Group& group);
/// Gives a group the class of ground on which most of its members get to where they are to go: its first
/// order's target, or where its mesh is. Of several the present one is kept, else the largest is taken. A
/// plan is bound to the ground of its class and begins again with it. Waits for background work before that.
void updateGroundClass(WorldState& state, Group& group, ThreadPool& pool);
/// The same for all groups, where something may have changed.
void updateGroundClasses(WorldState& state, ThreadPool& pool);

}  // namespace muster
