// Plain geometric types: polygons, triangle meshes and points on them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// Corners in order [m]; an edge joins the last to the first. Counter-clockwise unless noted otherwise.
using Polygon = std::vector<Vec2>;

/// An outline with holes; the outline runs counter-clockwise, holes clockwise.
struct PolygonWithHoles {
    Polygon outline;             ///< At least three corners [m].
    std::vector<Polygon> holes;  ///< Inside the outline, apart from each other [m].

    /// Lets an archive read or write the shape.
    template <class Archive>
    void visit(Archive& archive) {
        archive(outline, holes);
    }
    /// Equal in all parts.
    friend bool operator==(const PolygonWithHoles&, const PolygonWithHoles&) = default;
};

/// Three vertex indices, counter-clockwise.
using Triangle = std::array<std::int32_t, 3>;

/// Vertices and triangles.
struct TriangleMesh {
    std::vector<Vec2> vertices;       ///< Positions [m].
    std::vector<Triangle> triangles;  ///< Counter-clockwise; every vertex is used.

    /// Lets an archive read or write the mesh.
    template <class Archive>
    void visit(Archive& archive) {
        archive(vertices, triangles);
    }
};

/// A point of a mesh by its barycentric coordinates. It follows the mesh when that is deformed.
struct MeshPoint {
    std::int32_t triangle = 0;              ///< Index into the mesh's triangles.
    std::array<double, 3> weight{1, 0, 0};  ///< Barycentric coordinates; their sum is 1.

    /// Where the point lies for these vertex positions [m].
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

}  // namespace muster
