// Paths with at most one vertex: over ground of several unit costs with no wall in between (SPEC A3; Mitchell
// and Papadimitriou 1991), and around crowd and moving obstacles (SPEC A4, A5).
#pragma once

#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/static_ground.h"

namespace muster {

/// A path between two points with at most one vertex in between.
struct RefractedPath {
    /// Cost on the static ground [m]; an upper bound of the cheapest path's but for the discretisation by
    /// cells.
    double cost;
    Vec2 firstVertex;  ///< The first vertex after the start [m]; the end of a path without a bend.
};

/// The cheapest of the straight line and some paths with one vertex where the ground changes most. The
/// straight line must be free of walls.
RefractedPath refractedPath(const StaticGround& ground, Vec2 from, Vec2 to);

/// The dynamic cost between two points [m of open ground]: along the straight line of this length, or, where
/// that is cheaper, along a path with one vertex next to moving obstacles, including the length by which the
/// path exceeds the line. An upper bound for the cheapest path.
double dynamicCostBetween(const StaticGround& ground, const DynamicCost& dynamicCost, Vec2 a, Vec2 b,
                          double length);
inline double dynamicCostBetween(const StaticGround& ground, const DynamicCost& dynamicCost, Vec2 a, Vec2 b) {
    return dynamicCostBetween(ground, dynamicCost, a, b, distance(a, b));
}

}  // namespace muster
