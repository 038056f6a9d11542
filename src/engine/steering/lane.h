// The lane ahead of a walker: how far it gets along a heading until it comes up to somebody.
#pragma once

#include <cmath>
#include <limits>

#include "muster/vec2.h"

namespace muster {

/// Shoulders of two who walk one behind the other: the lane is wider than the two bodies are long by this
/// [m]. A radius of 0.18 m, which is half of the depth of a person, so has a lane of 0.46 m, the breadth of
/// its shoulders.
inline constexpr double kShoulders = 0.1;

/// How far a walker gets along a heading, a unit vector, until it comes up to somebody who stands off by
/// `between` [m]: 0 or less where they touch, infinite beside the lane and behind. They touch at the distance
/// `touching` [m] where one is straight ahead.
inline double wayAhead(Vec2 between, Vec2 heading, double touching) {
    const double along = dot(between, heading), beside = cross(heading, between);
    const double lane = touching + kShoulders;
    if (along <= 0.0 || beside * beside >= lane * lane) return std::numeric_limits<double>::infinity();
    return along - touching * std::sqrt(1.0 - beside * beside / (lane * lane));
}

}  // namespace muster
