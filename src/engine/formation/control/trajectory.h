// Drawn trajectories (paper section 4.2): cut into checkpoints, and followed by a clock.
#pragma once

#include "muster/control.h"

namespace muster {

inline constexpr std::size_t
    kMaxCheckpoints = 4096;  ///< Per trajectory; of a longer one every second is dropped.

/// Adds the finger's newest point, drawn at `time` [s]. At each full `spacing` [m] a checkpoint with
/// interpolated time is fixed; the last element is always the newest point.
void extendTrajectory(ControlPoint& point, Vec2 position, double time, double spacing);

/// The latest drawing time up to `until` [s] that a point at drawing time `clock` [s] reaches within `reach`
/// [m].
double latestReachable(const ControlPoint& point, double clock, double until, double reach);

/// Moves the point along its trajectory from drawing time `clock` to `until` [s], at most by `reach` [m].
void followTrajectory(ControlPoint& point, double clock, double until, double reach);

}  // namespace muster
