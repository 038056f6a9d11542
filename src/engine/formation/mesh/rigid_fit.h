// Rigid placements in the plane, and points as complex numbers, x + iy. The fit is the orthogonal Procrustes
// problem (Schönemann 1966), in closed form.
#pragma once

#include <span>

#include "muster/vec2.h"

namespace muster {

/// Rotates and scales `b` by `a`.
constexpr Vec2 complexProduct(Vec2 a, Vec2 b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

constexpr Vec2 complexConjugate(Vec2 a) {
    return {a.x, -a.y};
}

/// The pose of `rest` [m] that fits the corresponding `points` [m] best (least squares, equal weights, no
/// scaling).
Pose bestRigidFit(std::span<const Vec2> rest, std::span<const Vec2> points);

}  // namespace muster
