// Angles of headings, and poses between poses.
#pragma once

#include "base/maths.h"
#include "muster/vec2.h"

namespace muster {

/// Signed angle from one unit vector to another, (-pi, pi] [rad].
inline double angleBetween(Vec2 from, Vec2 to) {
    return arcTangent2(cross(from, to), dot(from, to));
}
/// Signed angle from one rotation to another, (-pi, pi] [rad].
inline double angleBetween(const Rotation& from, const Rotation& to) {
    return angleBetween(Vec2{from.c, from.s}, Vec2{to.c, to.s});
}
/// A rotation turned by an angle [rad].
Rotation turned(Rotation r, double angle);
/// The pose at a share of the path from one pose to another, straight on and by the smaller turn.
Pose between(const Pose& from, const Pose& to, double share);

}  // namespace muster
