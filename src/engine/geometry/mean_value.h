// Mean-value coordinates (Floater 2003; Hormann and Floater 2006).
#pragma once

#include <span>

#include "muster/vec2.h"

namespace muster {

/// Writes to `weights` (one per corner, sum 1) the mean-value coordinates of `p` in the polygon:
/// sum of weights times corners gives `p`. Exact on corners and edges. At least three corners.
void meanValueCoordinates(std::span<const Vec2> polygon, Vec2 p, std::span<double> weights);

}  // namespace muster
