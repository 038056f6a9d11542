// Who stands in its place, and what keeps the others from theirs.
#pragma once

#include <cstdint>
#include <span>

#include "engine/state/world_state.h"
#include "muster/generated/enumerations.h"

namespace muster {

/// What is found of one character.
struct StandingReport {
    Standing standing = Standing::InPlace;
    /// Where the formation wants it [m]; its own position where it has no place.
    Vec2 wanted;
};

/// What keeps a group from standing at a point; Crowded where the ground does not. `region` is where it can
/// go, -1 for anywhere.
Standing barOf(const WorldState& state, const Group& group, std::int32_t region, Vec2 point);

/// Judges all members of a group by the last step; `reports` has an entry per character of the world, of
/// which those of the group are written.
void judgeStandings(const WorldState& state, const Group& group, std::span<StandingReport> reports);

}  // namespace muster
