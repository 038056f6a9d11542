// Drawn trajectories: cutting into checkpoints, and following by a clock.
#pragma once

#include "muster/control.h"

namespace muster {

inline constexpr std::size_t kMaxCheckpoints = 4096;  ///< Per path; a longer one keeps every second.

/// Adds the finger's newest point. Full spacings become fixed checkpoints with interpolated drawing
/// time; the last element always is the newest point.
void extendPath(ControlPoint& point, Vec2 position, double time, double spacing);

/// The latest drawing time up to `until` [s] that a point at `clock` can reach within `reach` [m].
double clockWithin(const ControlPoint& point, double clock, double until, double reach);

/// Moves the point along its path from drawing time `clock` to `until`, at most `reach` [m].
void followPath(ControlPoint& point, double clock, double until, double reach);

}  // namespace muster
