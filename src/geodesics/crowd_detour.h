// The excess of the cheapest of a few ways between two points in sight of each other (SPEC A4, A5).
#pragma once

#include "cost/dynamic_cost.h"
#include "cost/static_ground.h"

namespace muster {

/// What crowd and moving things add between two points [m of open ground]: along the straight line, or along
/// a way bent once round moving things, with what it is longer than the line, where that is less. Never less
/// than the cheapest way has. `line` is the length of the straight line.
double excessBetween(const StaticGround& ground, const DynamicCost& excess, Vec2 a, Vec2 b, double line);
inline double excessBetween(const StaticGround& ground, const DynamicCost& excess, Vec2 a, Vec2 b) {
    return excessBetween(ground, excess, a, b, distance(a, b));
}

}  // namespace muster
