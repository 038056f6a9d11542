// The sole of a foot.
#pragma once

#include "muster/quat.h"

namespace muster {

/// Heel or ball of a foot turned like this, whichever is lower; from the ankle, in the foot's own frame [m].
inline Vec3 touchingPoint(Quat rotation) {
    constexpr Vec3 kHeel{-0.05f, 0.0f, -0.08f}, kBall{0.13f, 0.0f, -0.08f};
    return rotate(rotation, kHeel).z < rotate(rotation, kBall).z - 0.002f ? kHeel : kBall;
}

}  // namespace muster
