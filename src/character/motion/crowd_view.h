// What motion reads of a crowd.
#pragma once

#include "crowd/characters.h"
#include "environment/environment.h"
#include "muster/motion.h"
#include "muster/parameters.h"

namespace muster {

inline constexpr double
    kPutElsewhere = 0.5;  ///< A character that moves farther in one step was put there [m].

/// Places of one group, as the simulation moves them.
struct PlacesView {
    std::span<const Vec2> positions;   ///< [m]
    std::span<const Vec2> velocities;  ///< [m/s]
};

/// What motion reads of a world.
struct CrowdView {
    const Characters* characters = nullptr;  ///< In ascending order of ids.
    const Environment* environment = nullptr;
    std::span<const PlacesView> places;                  ///< By group; may be fewer than groups.
    double stepTime = Parameters{}.stepTime;             ///< [s] > 0.
    double maxSpeed = Parameters::Character{}.maxSpeed;  ///< In the open [m/s].
    /// A place nearer than this is steered to directly [m].
    double directReach = Parameters::Character{}.directReach;
};

}  // namespace muster
