// Triangle meshes from outlines, and the convex parts of polygons (Hertel and Mehlhorn 1983).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/polygon.h"

namespace muster {

/// Barycentric coordinates of `p` in the triangle; negative outside.
std::array<double, 3> barycentric(Vec2 a, Vec2 b, Vec2 c, Vec2 p);

/// Squared distance of `p` from a triangle with these corners [m^2], 0 inside, and the barycentric
/// coordinates of its nearest point.
double squaredDistance(const std::array<Vec2, 3>& corner, Vec2 p, std::array<double, 3>& weight);
/// True where squaredDistance() is exactly 0; quick where it is not. Else `weight` is undefined.
bool holds(const std::array<Vec2, 3>& corner, Vec2 p, std::array<double, 3>& weight);

/// Delaunay triangulation of distinct points (Bowyer-Watson). Fails with InvalidArgument where
/// fewer than three are given or all lie on one line.
Result<std::vector<Triangle>> delaunay(std::span<const Vec2> points);

/// Meshes an outline with holes: boundary sampled at most `spacing` [m] apart, interior sampled on
/// a uniform lattice, conforming Delaunay triangulation. Fails as cleanPolygon does, or where holes
/// leave the outline or meet each other, or where more than 20,000 vertices would be needed.
Result<TriangleMesh> triangulate(const PolygonWithHoles& shape, double spacing);

/// Boundary edges of a mesh as closed loops of vertex indices (outer loops counter-clockwise).
std::vector<std::vector<std::int32_t>> boundaryLoops(const TriangleMesh& mesh);

/// The mesh point nearest to `p` for these vertex positions (inside: the triangle that holds it).
MeshPoint locate(const std::vector<Triangle>& triangles, const std::vector<Vec2>& vertices, Vec2 p);

/// Cuts a simple polygon into few convex parts that cover it exactly and do not overlap, by ear clipping and
/// merging of triangles across shared diagonals. A convex polygon is returned as one part. Fails where
/// cleanPolygon() fails.
Result<std::vector<Polygon>> decomposeConvex(std::span<const Vec2> polygon);

}  // namespace muster
