// Hand-over of places: who is kept from its place by others who stand lets one of them have it (SPEC A7).
#pragma once

#include <cstdint>
#include <span>

#include "base/neighbour_list.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/walk_progress.h"

namespace muster {

struct Characters;

/// What the rule reads of the parameters.
struct HandOverDef {
    double gap = 0.0;       ///< Two characters touch up to this gap between them [m].
    double topSpeed = 0.0;  ///< In the open, of who has none of its own [m/s].
    /// Per character: by how much farther than others it may stand from a place that it shares [m] >= 0;
    /// empty for none.
    std::span<const double> room = {};
};

/// Updates the waits of all characters for one step of `dt` [s]. `neighbours` lists all pairs that touch; one
/// that stands near its place bars the way of another of its group. A wait counts like a walk: the cost of
/// the barred place rises at top speed, and falls slowly once the character has got on or another place.
void updateWaits(const HandOverDef& def, const Characters& now, const CrowdBodies& bodies,
                 const NeighbourList& neighbours, double dt, std::span<PlaceWait> waits);

}  // namespace muster
