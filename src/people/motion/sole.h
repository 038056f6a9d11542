// The touching point of a foot's sole.
#pragma once

#include "muster/quat.h"

namespace muster {

/// The lower one of heel and ball of a foot with this rotation, relative to the ankle in the foot's own frame
/// [m].
inline Vec3 touchingPoint(Quat rotation) {
    constexpr Vec3 kHeel{-0.05f, 0.0f, -0.08f}, kBall{0.13f, 0.0f, -0.08f};
    return rotate(rotation, kHeel).z < rotate(rotation, kBall).z - 0.002f ? kHeel : kBall;
}

}  // namespace muster
