// The rigid placement that fits point sets best (orthogonal Procrustes problem, Schönemann 1966; in the plane
// in closed form).
#pragma once

#include <span>

#include "muster/vec2.h"

namespace muster {

/// The pose of `rest` [m] that fits the corresponding `points` [m] best (least squares, equal weights, no
/// scaling).
Pose bestRigidFit(std::span<const Vec2> rest, std::span<const Vec2> points);

}  // namespace muster
