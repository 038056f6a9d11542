// Where a character's own frame goes, by the way its hips go.
#pragma once

#include <span>
#include <vector>

#include "muster/clip.h"

namespace muster {

/// Hips in one frame, seen from above.
struct HipsAt {
    double x = 0.0, y = 0.0;  ///< [m]
    double facing = 0.0;      ///< [rad], going on from frame to frame without jumps.
};

/// Takes out the jumps of a whole turn.
void unwrap(std::vector<HipsAt>& hips);

/// Evenly from the first frame to the last: straight, or along an arc where the body turns by more than a
/// fifth of a right angle and a bit. Ends lie under the hips but for a constant shift. As many as hips.
std::vector<Travel> evenTravel(std::span<const HipsAt> hips);

/// As the hips go, smoothed over `window` [s]; both ends lie under the hips. As many as hips.
std::vector<Travel> smoothTravel(std::span<const HipsAt> hips, double rate, double window);

/// The same from its first frame on: that becomes (0, 0, 0).
void fromStart(std::vector<Travel>& travel);

}  // namespace muster
