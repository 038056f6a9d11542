// Points of the plane as complex numbers, x + iy.
#pragma once

#include "muster/vec2.h"

namespace muster {

/// Rotates and scales `b` by `a`.
constexpr Vec2 complexProduct(Vec2 a, Vec2 b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

constexpr Vec2 complexConjugate(Vec2 a) {
    return {a.x, -a.y};
}

}  // namespace muster
