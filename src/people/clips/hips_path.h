// The path of a character's travelling frame, derived from the path of its hips.
#pragma once

#include <span>
#include <vector>

#include "muster/clip.h"

namespace muster {

/// Position and facing of the hips on the ground plane in one frame.
struct HipsAt {
    double x = 0.0, y = 0.0;  ///< Coordinates on the ground plane [m].
    double facing = 0.0;      ///< Yaw without jumps from frame to frame [rad].
};

/// Removes jumps of 360 degrees from the facing.
void unwrap(std::vector<HipsAt>& hips);

/// Travel at constant speed from the first frame to the last: straight, or along an arc if the body turns by
/// more than 0.35 rad. Its ends lie under the hips except for a constant shift. One entry per frame.
std::vector<Travel> evenTravel(std::span<const HipsAt> hips);

/// Travel along the path of the hips, smoothed over `window` [s]; both ends lie under the hips. One entry per
/// frame.
std::vector<Travel> smoothTravel(std::span<const HipsAt> hips, double rate, double window);

/// Expresses the travel relative to its first frame, which becomes (0, 0, 0).
void fromStart(std::vector<Travel>& travel);

}  // namespace muster
