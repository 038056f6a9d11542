// Whether a group and its places have come to rest.
#pragma once

#include <cstddef>

#include "engine/state/group.h"
#include "engine/steering/walk_progress.h"

namespace muster {

inline constexpr double kStandingPlaceSpeed = 0.1;  ///< Speed below which a place counts as standing [m/s].

/// True while trajectories are still to be followed, or a control that was let go is ending.
inline bool isDrawn(const Group& group) {
    for (const Control& control : group.controls.controls())
        for (const ControlPoint& point : control.points)
            if (!point.trajectory.empty() || (!point.down && !control.pinned)) return true;
    return false;
}

/// True while the mesh has not reached the end of the order that is carried out.
inline bool isOnItsWay(const Group& group) {
    return group.orders.begun && !group.orders.held && group.orders.march.phase != MarchPhase::Stand;
}

/// True where a place stands at its reachable target.
inline bool placeRests(const PlaceTracker& places, std::size_t place) {
    return length(places.velocities()[place]) <= kStandingPlaceSpeed &&
           distance(places.positions()[place], places.reachableTargets()[place]) <= kArrivedReach;
}

}  // namespace muster
