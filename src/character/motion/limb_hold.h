// Holding one foot or hand where it touches.
#pragma once

#include "character/motion/body.h"

namespace muster {

/// Anchors higher than this lie on an obstacle, which does not scale with the body [m].
inline constexpr float kFixedHeight = 0.3f;

/// Between the world and a body of size 1.
struct BodyFrame {
    Vec2 position;  ///< [m]
    Rotation facing;
    Quat turn;  ///< The same as `facing`.
    float size = 1.0f;

    /// Where a character stands.
    explicit BodyFrame(const Mover& mover);
    /// Into the body's frame.
    Vec3 toBody(Vec2 place, float height) const;
    /// Into the world: place on the ground.
    Vec2 toGround(Vec3 p) const { return position + facing.apply({p.x, p.y}) * static_cast<double>(size); }
};

/// The rotation about the vertical that a plane rotation is.
Quat uprightTurn(const Rotation& rotation);

/// Where a joint is to be, in the body's frame, and how it is turned.
struct LimbTarget {
    Vec3 place;  ///< [m]
    Quat rotation;
};

/// Takes, keeps or lets go limb `limb` of the body, which would be at `free` if nothing were held, and tells
/// where it is to be. A limb is taken where it is when its contact begins, and held there until the contact
/// ends or the body has moved on too far; what differs then fades away.
LimbTarget holdLimb(const ClipTable& table, const Mover& mover, const BodyFrame& frame, std::size_t limb,
                    const LimbTarget& free, float dt, Body& body);

}  // namespace muster
