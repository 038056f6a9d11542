// Detour around dynamic cost: what crowd and moving obstacles add between two points in line of sight (SPEC
// A4, A5).
#pragma once

#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/static_ground.h"

namespace muster {

/// The dynamic cost between two points [m of open ground]: along the straight line of this length, or, where
/// that is cheaper, along a path with one vertex next to moving obstacles, including what the path is longer
/// than the line. An upper bound of that of the cheapest path.
double dynamicCostBetween(const StaticGround& ground, const DynamicCost& dynamicCost, Vec2 a, Vec2 b,
                          double length);
inline double dynamicCostBetween(const StaticGround& ground, const DynamicCost& dynamicCost, Vec2 a, Vec2 b) {
    return dynamicCostBetween(ground, dynamicCost, a, b, distance(a, b));
}

}  // namespace muster
