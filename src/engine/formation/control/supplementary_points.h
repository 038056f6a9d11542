// Supplementary points of line and area controls (paper section 4.1, SPEC U4, U5).
#pragma once

#include "muster/control.h"

namespace muster {

/// Samples the supplementary points of a control from the rest mesh, about `spacing` [m] apart, and sets
/// their weights: linear between the ends of a line, mean-value coordinates (Floater 2003) in the rest hull
/// of an area. Points that the mesh does not cover are left out. The kind must suit the number of points.
void sampleSupplementary(Control& control, const TriangleMesh& rest, double spacing);

}  // namespace muster
