// Triangle meshes from outlines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/polygon.h"

namespace muster {

/// Three vertex indices, counter-clockwise.
using Triangle = std::array<std::int32_t, 3>;

/// Vertices and triangles.
struct TriangleMesh {
    std::vector<Vec2> vertices;       ///< [m]
    std::vector<Triangle> triangles;  ///< Counter-clockwise, every vertex used.

    /// Lets an archive read or write the mesh.
    template <class Archive>
    void visit(Archive& archive) {
        archive(vertices, triangles);
    }
};

/// A point of a mesh: triangle and weights of its corners (sum 1).
struct MeshPoint {
    std::int32_t triangle = 0;              ///< Index into the mesh's triangles.
    std::array<double, 3> weight{1, 0, 0};  ///< Barycentric coordinates.

    /// Where the point lies for these vertex positions.
    Vec2 position(const std::vector<Triangle>& triangles, const std::vector<Vec2>& vertices) const {
        const Triangle& t = triangles[triangle];
        return vertices[t[0]] * weight[0] + vertices[t[1]] * weight[1] + vertices[t[2]] * weight[2];
    }
    /// Lets an archive read or write the point.
    template <class Archive>
    void visit(Archive& archive) {
        archive(triangle, weight);
    }
};

/// Barycentric coordinates of `p` in the triangle; negative outside.
std::array<double, 3> barycentric(Vec2 a, Vec2 b, Vec2 c, Vec2 p);

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

}  // namespace muster
