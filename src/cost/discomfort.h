// Discomfort ahead of moving obstacles (SPEC A5; Treuille, Cooper and Popovic 2006, section 4.1).
#pragma once

#include <cstdint>
#include <vector>

#include "cost/unit_cost.h"
#include "muster/obstacle.h"

namespace muster {

/// Raises `discomfort` where this piece is predicted, and lists cells that had none in `touched`.
void addDiscomfort(const UnitCostDef& def, const ObstaclePiece& piece, const Grid& grid,
                   std::vector<float>& discomfort, std::vector<std::int32_t>& touched);

/// Discomfort of one piece at one point: gain (1 - t / time) (1 - d / range), largest over the predicted
/// times t, with d the distance to the piece as moved by t; 0 where d exceeds the range throughout.
/// `precision` is that of the time of the peak, relative to the time predicted.
double discomfortAt(const UnitCostDef& def, const ObstaclePiece& piece, Vec2 p, double precision = 1e-9);

}  // namespace muster
