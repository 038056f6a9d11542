// Foot lock: keeps one foot or hand where it touches while its contact lasts (docs/method/motion.md).
#pragma once

#include "character/motion/body.h"

namespace muster {

/// Anchors higher than this lie on an obstacle, which does not scale with the body [m].
inline constexpr float kFixedHeight = 0.3f;

/// The axes of a body of size 1 in the world: x forward, y left, z up, from the ground below it.
struct BodyAxes {
    Vec2 position;      ///< Of the origin [m].
    Rotation facing;    ///< From the body's axes to the world's.
    Quat rotation;      ///< The same as `facing`.
    float size = 1.0f;  ///< Of the body relative to the skeleton.

    explicit BodyAxes(const Mover& mover);
    /// From the world into the body's axes.
    Vec3 toBody(Vec2 point, float height) const;
    /// The point of the ground below a point in the body's axes.
    Vec2 toGround(Vec3 p) const { return position + facing.apply({p.x, p.y}) * static_cast<double>(size); }
};

/// The rotation about the vertical that equals a rotation of the plane.
Quat yawRotation(const Rotation& rotation);

/// Where a joint is to be, in the body's axes.
struct LimbTarget {
    Vec3 position;  ///< [m]
    Quat rotation;
};

/// Locks, keeps or releases limb `limb` (index of kLockableLimbs) and returns its target. `free` is where the
/// clip alone would put it. A limb is locked where it is when its contact begins, and released when the
/// contact ends or the body has moved on too far; the remaining offset then fades.
LimbTarget lockLimb(const ClipTable& table, const Mover& mover, const BodyAxes& axes, std::size_t limb,
                    const LimbTarget& free, float dt, Body& body);

}  // namespace muster
