// The data of a crowd that motion reads.
#pragma once

#include <optional>
#include <span>

#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "muster/generated/parameters.h"
#include "muster/motion.h"

namespace muster {

/// Distance in one step above which a character was teleported [m].
inline constexpr double kPutElsewhere = 0.5;

/// Places of one group, which the simulation moves.
struct PlacesView {
    std::span<const Vec2> positions;   ///< Positions [m].
    std::span<const Vec2> velocities;  ///< Velocities [m/s].
};

/// The data of a world that motion reads.
struct CrowdView {
    const Characters* characters = nullptr;  ///< Characters in ascending order of ids.
    const Environment* environment = nullptr;
    std::span<const PlacesView> places;  ///< Places by group; may be fewer than groups.
    /// Motion set of each group; it may have fewer entries than there are groups.
    std::span<const std::optional<MotionSet>> motionSets;
    /// The clip that each character is to play where its ground asks for none, -1 for none; empty for all
    /// none.
    std::span<const std::int32_t> chosenClips;
    double stepTime = Parameters{}.stepTime;             ///< Duration of a step [s] > 0.
    double maxSpeed = Parameters::Character{}.maxSpeed;  ///< Top speed on open ground [m/s].
    /// Distance to a place below which a character steers directly to it [m].
    double directReach = Parameters::Character{}.directReach;
};

}  // namespace muster
