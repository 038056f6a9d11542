// Measures how far a deformed mesh is from its rest shape.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/triangulation.h"

namespace muster {

/// Deviation of each triangle's deformation gradient F (rest to deformed) from the rotation R nearest to it:
/// the Frobenius norm |F - R|. 0 for a triangle moved rigidly, 0.1 x sqrt(2) for one enlarged by a tenth.
std::vector<double> triangleDistortion(const TriangleMesh& rest, std::span<const Vec2> deformed);

/// As-rigid-as-possible energy: the sum over triangles of area x |F - R|^2 [m^2].
double arapEnergy(const TriangleMesh& rest, std::span<const Vec2> deformed);

/// Mean of |F - R| weighted by area, of the triangles whose rest centroid is left of x = 0 and of those right
/// of it.
double meanDistortion(const TriangleMesh& rest, std::span<const Vec2> deformed, bool left);

}  // namespace muster
