// Boxes that move, and the times at which two of them meet.
#pragma once

#include <limits>

#include "base/maths.h"
#include "muster/vec2.h"

namespace muster {

/// A box that moves at one velocity for a while. With no size it is a disc of radius `round`.
struct MovingBox {
    Vec2 centre;          ///< Centre at time 0, extrapolated where the box is not there yet [m].
    Vec2 axis{1.0, 0.0};  ///< Unit vector along its length.
    Vec2 half;            ///< Half its length and half its width [m].
    double round = 0.0;   ///< Distance added all round [m].
    Vec2 velocity;        ///< [m/s]
    double from = 0.0;    ///< Time from which it is there [s]...
    double to = std::numeric_limits<double>::infinity();  ///< ... and until which it is there [s].

    /// Radius of the circle about its centre that holds it [m].
    double reach() const { return length(half) + round; }
};

/// The rotation by an angle [rad].
inline Rotation rotationBy(double angle) {
    return {cosine(angle), sine(angle)};
}

/// A span of time [s]; empty where `from` is later than `to`.
struct TimeSpan {
    double from = 0.0;
    double to = 0.0;

    bool empty() const { return from > to; }  ///< True where the span has no time.
};

/// The time while two boxes meet, with `margin` [m] added to one of them. Exact by separating axes for boxes
/// without `round` and for two discs; otherwise corners count as if they were not rounded.
TimeSpan contactSpan(const MovingBox& a, const MovingBox& b, double margin = 0.0);

}  // namespace muster
