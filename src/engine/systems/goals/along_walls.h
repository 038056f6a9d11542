// The direction of a body that touches a wall (docs/method/goals.md).
#pragma once

#include "base/function_ref.h"
#include "engine/ground/environment/environment.h"

namespace muster {

/// The direction in which a body at `p` gets on if it is led along `direction`, a unit vector or null. A
/// direction from cells knows walls only roughly: where a step along it would end in a wall that the body
/// touches, the body goes along that wall instead, to the side where `cost` is less. Unchanged elsewhere, and
/// where the body is held on all sides.
Vec2 alongWalls(const Environment& environment, Vec2 p, double radius, Vec2 direction,
                FunctionRef<double(Vec2)> cost);

}  // namespace muster
