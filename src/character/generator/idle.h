// Standing.
#pragma once

#include "character/generator/leg_track.h"
#include "muster/clip.h"

namespace muster::generator {

inline constexpr double kIdleCycle = 4.0;  ///< [s]

/// Trunk, head and arms of one who stands, breathes and shifts weight; phase 0 at time `start`.
Body idleBody(double time, double start = 0.0);
/// A standing foot for all time, the character at `place`.
Step idleStep(std::size_t side, const Placement& place);
/// The clip "idle".
Clip idleClip();

}  // namespace muster::generator
