// Discomfort ahead of moving obstacles (SPEC A5; Treuille, Cooper and Popovic 2006, section 4.1).
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "engine/ground/environment/obstacle_piece.h"
#include "muster/parameters.h"

namespace muster {

/// Discomfort g of one obstacle piece at one point: gain (1 - t / time) (1 - d(t) / range), the maximum over
/// the predicted times t, with d the distance to the piece moved by t; 0 where d exceeds the range at all
/// times. `precision` is that of the time of the maximum, relative to the time predicted.
double discomfortAt(const Parameters::Discomfort& def, const ObstaclePiece& piece, Vec2 p,
                    double precision = 1e-9);

/// Raises `discomfort` on the cells in reach of this piece, and appends those that had none to `cells`.
void addDiscomfort(const Parameters::Discomfort& def, const ObstaclePiece& piece, const Grid& grid,
                   std::vector<float>& discomfort, std::vector<std::int32_t>& cells);

}  // namespace muster
