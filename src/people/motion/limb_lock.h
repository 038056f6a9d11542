// Foot lock: fixes a foot or hand at its contact point while the contact lasts (docs/method/motion.md).
#pragma once

#include "muster/quat.h"
#include "people/motion/posed_body.h"

namespace muster {

/// The lower point of heel and ball of a foot with this rotation, relative to the ankle in the foot's own
/// frame [m].
inline Vec3 touchingPoint(Quat rotation) {
    constexpr Vec3 kHeel{-0.05f, 0.0f, -0.08f}, kBall{0.13f, 0.0f, -0.08f};
    return rotate(rotation, kHeel).z < rotate(rotation, kBall).z - 0.002f ? kHeel : kBall;
}

/// Height above which anchors lie on an obstacle, which does not scale with the body [m].
inline constexpr float kFixedHeight = 0.3f;

/// The axes of a body of size 1 in the world: x forward, y left, z up, from the ground below it.
struct BodyFrame {
    Vec2 position;      ///< Position of the origin [m].
    Rotation facing;    ///< Rotation from the body axes to the world.
    Quat rotation;      ///< Rotation `facing` as a quaternion.
    float size = 1.0f;  ///< Size of the body relative to the skeleton.

    explicit BodyFrame(const Mover& mover);
    /// Transforms a point from the world to the body axes.
    Vec3 toBody(Vec2 point, float height) const;
    /// The point on the ground below a point in the body axes.
    Vec2 toGround(Vec3 p) const { return position + facing.apply({p.x, p.y}) * static_cast<double>(size); }
};

/// The rotation about the vertical that is equivalent to a rotation of the plane.
Quat yawRotation(const Rotation& rotation);

/// Target of a joint, in the body axes.
struct LimbTarget {
    Vec3 position;  ///< Position [m].
    Quat rotation;  ///< Rotation of the joint.
};

/// Updates the lock of a limb (index of kLockableLimbs) and returns its target. `free` is the target by the
/// clip alone. A limb is locked at its position when its contact begins. It is released when the contact ends
/// or the body has moved too far; then the remaining offset fades.
LimbTarget lockLimb(const ClipTable& table, const Mover& mover, const BodyFrame& axes, std::size_t limb,
                    const LimbTarget& free, float dt, PosedBody& body);

}  // namespace muster
