// Cheapest paths traced down a cost field (midpoint method), for pictures and path lengths.
#pragma once

#include <vector>

#include "engine/fields/eikonal/cost_field.h"

namespace muster {

/// Traces the path from `from` to the field's source in steps of `step` [m], > 0, and writes its points, both
/// ends included. `path` is empty where the field does not reach `from`. Always ends; returns true where the
/// source was reached.
bool tracePath(const CostField& field, Vec2 from, double step, std::vector<Vec2>& path);

/// Length of a polyline [m].
double pathLength(const std::vector<Vec2>& path);

}  // namespace muster
