// The way down a cost field, for pictures and path lengths.
#pragma once

#include <vector>

#include "eikonal/cost_field.h"

namespace muster {

/// Walks from `from` down to the field's source in steps of `step` [m] > 0 and writes the corner points, both
/// ends included; the last one is the source where it was reached. Empty where the field does not reach
/// `from`. Always ends. Returns true where the source was reached.
bool tracePath(const CostField& field, Vec2 from, double step, std::vector<Vec2>& path);

/// Length of a chain of points [m].
double pathLength(const std::vector<Vec2>& path);

}  // namespace muster
