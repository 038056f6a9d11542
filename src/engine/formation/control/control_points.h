// Points of controls (paper sections 4.1 and 4.2, SPEC U4, U5): supplementary points of lines and areas, and
// drawn trajectories, cut into checkpoints and followed by a clock.
#pragma once

#include "muster/generated/control.h"

namespace muster {

inline constexpr std::size_t
    /// Greatest number of checkpoints of a trajectory; of a longer one every second is dropped.
    kMaxCheckpoints = 4096;

/// Adds the finger's newest point, drawn at `time` [s]. At each full `spacing` [m] a checkpoint with
/// interpolated time is fixed; the last element is always the newest point.
void extendTrajectory(ControlPoint& point, Vec2 position, double time, double spacing);

/// The latest drawing time up to `until` [s] that a point at drawing time `clock` [s] reaches within `reach`
/// [m].
double latestReachable(const ControlPoint& point, double clock, double until, double reach);

/// Moves the point along its trajectory from drawing time `clock` to `until` [s], at most by `reach` [m].
void followTrajectory(ControlPoint& point, double clock, double until, double reach);

/// Samples the supplementary points of a control from the rest mesh, about `spacing` [m] apart, and sets
/// their weights: linear between the ends of a line, mean-value coordinates (Floater 2003) in the rest hull
/// of an area. Points that the mesh does not cover are left out. The kind must suit the number of points.
void sampleSupplementary(Control& control, const TriangleMesh& rest, double spacing);

}  // namespace muster
