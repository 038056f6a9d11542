// Ways over ground of several speeds, with no wall in between (SPEC A3).
#pragma once

#include "cost/static_ground.h"

namespace muster {

/// A way between two points, bent at most once.
struct SlowWay {
    /// Of the still ground; never less than that of the cheapest way but for rounding by cells.
    double cost;
    Vec2 aim;  ///< Where to walk first: the bend, or the end.
};

/// The cheapest of a few ways that bend where the ground changes: light and people are refracted there. The
/// line itself is taken to be clear of walls.
SlowWay slowWay(const StaticGround& ground, Vec2 from, Vec2 to);

}  // namespace muster
