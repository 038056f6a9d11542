// The path of a character and the pose of its trunk, head and arms, as functions of time.
#pragma once

#include <functional>

#include "muster/clip.h"
#include "people/generator/figure.h"

namespace muster::generator {

/// The travelling frame on the ground [m, rad].
struct Placement {
    double x = 0.0;    ///< Coordinate along x [m].
    double y = 0.0;    ///< Coordinate along y [m].
    double yaw = 0.0;  ///< Yaw [rad].
};

/// Transforms a point from the travelling frame at `place` to the ground frame, and back.
Vec3 toGround(const Placement& place, Vec3 point);
Vec3 fromGround(const Placement& place, Vec3 point);

/// Travel and body as functions of time [s].
struct Course {
    std::function<Placement(double)> travel;
    std::function<ChannelValues(double)> body;  ///< Channel values in the travelling frame.
};

/// A straight path along x, given as distance [m] by time.
std::function<Placement(double)> straight(std::function<double(double)> x);

}  // namespace muster::generator
