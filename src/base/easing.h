// Angles and shares between two ends.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {

/// The same angle in [-pi, pi) [rad].
inline double wrappedAngle(double angle) {
    return angle - 2.0 * kPi * std::floor(angle / (2.0 * kPi) + 0.5);
}

/// 0 up to a share of 0, 1 from a share of 1 on, smooth between.
inline double smoothStep(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

}  // namespace muster
