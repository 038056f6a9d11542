// The lane ahead of a walker: the distance that it gets along a heading until it comes up to another agent.
#pragma once

#include <cmath>
#include <limits>

#include "muster/vec2.h"

namespace muster {

/// Width by which the lane of two bodies exceeds their touching distance [m]: the breadth of shoulders. A
/// radius of 0.18 m, half the depth of a person, so has a lane of 0.46 m, the breadth of its shoulders.
inline constexpr double kShoulders = 0.1;

/// Distance that a walker gets along a heading, a unit vector, until it comes up to an agent at `between`
/// [m]: 0 or less where they touch, infinite beside the lane and behind. They touch at the distance
/// `touching` [m] where the agent is straight ahead.
inline double wayAhead(Vec2 between, Vec2 heading, double touching) {
    const double along = dot(between, heading), beside = cross(heading, between);
    const double lane = touching + kShoulders;
    if (along <= 0.0 || beside * beside >= lane * lane) return std::numeric_limits<double>::infinity();
    return along - touching * std::sqrt(1.0 - beside * beside / (lane * lane));
}

}  // namespace muster
