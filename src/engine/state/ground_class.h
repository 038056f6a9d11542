// Classes of ground: planning for bodies of several sizes (SPEC A2).
#pragma once

#include <cstdint>

#include "base/parallel.h"
#include "engine/state/world_state.h"

namespace muster {

/// The class of ground for a body: 0 for one of the usual radius [m], one more for each factor of the square
/// root of 2 above it. All bodies of a class fit where its largest fits.
std::int32_t groundClassFor(double usual, double radius);
/// The largest radius of a class [m].
double groundRadius(double usual, std::int32_t groundClass);
/// The class of ground for a group: that of its largest member.
std::int32_t groundClassFor(const WorldState& state, const Group& group);
/// Mean radius of a group's members [m]; the usual one where there are none.
double meanRadius(const WorldState& state, const Group& group);
/// How the places of a group travel: with room for its members.
PlaceDef placeDefOf(const WorldState& state, const Group& group);
/// Gives groups whose largest member has become another one their class. Their plans, which are bound to the
/// ground of their class, begin again. Waits for background work before that.
void updateGroundClasses(WorldState& state, ThreadPool& pool);

}  // namespace muster
