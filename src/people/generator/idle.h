// The clip of standing.
#pragma once

#include "muster/clip.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

inline constexpr double kIdleCycle = 4.0;  ///< [s]

/// Trunk, head and arms of a body that stands, breathes and shifts its weight; phase 0 at time `start`.
ChannelValues idleBody(double time, double start = 0.0);
/// The step of a foot that stands for all time, with the character at `place`.
Step idleStep(std::size_t side, const Placement& place);
/// The clip "idle".
Clip idleClip();

}  // namespace muster::generator
