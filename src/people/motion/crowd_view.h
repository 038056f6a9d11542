// The data of a crowd that motion reads.
#pragma once

#include <optional>
#include <span>

#include "engine/ground/environment/environment.h"
#include "engine/steering/characters.h"
#include "muster/motion.h"
#include "muster/parameters.h"

namespace muster {

/// A character that moves farther in one step was teleported [m].
inline constexpr double kPutElsewhere = 0.5;

/// Places of one group, which the simulation moves.
struct PlacesView {
    std::span<const Vec2> positions;   ///< [m]
    std::span<const Vec2> velocities;  ///< [m/s]
};

/// The data of a world that motion reads.
struct CrowdView {
    const Characters* characters = nullptr;  ///< In ascending order of ids.
    const Environment* environment = nullptr;
    std::span<const PlacesView> places;  ///< By group; may be fewer than groups.
    /// How each group walks; it may have fewer entries than there are groups.
    std::span<const std::optional<MotionSet>> motionSets;
    double stepTime = Parameters{}.stepTime;             ///< Duration of a step [s] > 0.
    double maxSpeed = Parameters::Character{}.maxSpeed;  ///< On open ground [m/s].
    /// A character steers directly to a place nearer than this [m].
    double directReach = Parameters::Character{}.directReach;
};

}  // namespace muster
