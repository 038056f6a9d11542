// Refracted paths: the cheapest path over ground of several unit costs, with no wall in between (SPEC A3;
// Mitchell and Papadimitriou 1991).
#pragma once

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

}  // namespace muster
