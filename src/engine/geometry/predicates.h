// Exact signs of the two determinants that triangulation stands on.
#pragma once

#include "muster/vec2.h"

namespace muster {

/// 1 where a, b, c turn left, -1 where they turn right, 0 where they lie exactly on one line.
int orientation(Vec2 a, Vec2 b, Vec2 c);

/// 1 where `d` lies inside the circle through the left-turning a, b, c, -1 outside, 0 exactly on it.
int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace muster
