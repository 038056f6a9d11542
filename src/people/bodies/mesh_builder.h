// Builds meshes from rings of points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "people/bodies/body_mesh.h"

namespace muster::bodies {

using Ring = std::vector<std::uint32_t>;  ///< Indices of vertices, in order round an axis.

/// Part of a body, which decides how its vertices are weighted to the joints.
enum class Part : std::uint8_t { Trunk, Leg, Arm, Shoe, Head };

/// Material of new vertices.
struct Stuff {
    BodyRegion region = BodyRegion::Skin;
    Part part = Part::Trunk;
    Vec3 colour;  ///< Linear red, green, blue, 0 to 1.
};

/// Collects vertices and triangles. Triangles that share vertices are shaded as one smooth surface.
class MeshBuilder {
public:
    /// While true, everything added is mirrored to the other side of the body: y is negated and the winding
    /// of triangles is reversed.
    void setMirrored(bool mirrored) { mirrored_ = mirrored; }

    /// Adds one vertex.
    std::uint32_t add(Vec3 position, const Stuff& stuff);
    /// Adds one vertex for each point.
    Ring add(std::span<const Vec3> points, const Stuff& stuff);
    /// Position of a vertex [m].
    Vec3 at(std::uint32_t vertex) const { return flipped(vertices_[vertex].position); }
    /// Mean position of a ring's vertices [m].
    Vec3 middle(std::span<const std::uint32_t> ring) const;

    /// Adds a triangle, anticlockwise seen from outside.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Joins two rows of equal size by triangles. Seen from outside, `to` lies to the left of the direction
    /// of `from`. In closed rows the last vertices are joined with the first.
    void bridge(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, bool closed = true);
    /// Closes a ring with a point to the left of its direction, or to the right.
    void cap(const Ring& ring, Vec3 tip, const Stuff& stuff, bool left = true);

    /// The mesh with normals and weights, its triangles grouped by region.
    BodyMesh finish();

private:
    Vec3 flipped(Vec3 p) const { return mirrored_ ? Vec3{p.x, -p.y, p.z} : p; }
    void findNormals();

    std::vector<BodyVertex> vertices_;
    std::vector<Part> parts_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    bool mirrored_ = false;
};

/// Sets joints and weights of a vertex by its position and its part.
void setWeights(Part part, BodyVertex& vertex);

}  // namespace muster::bodies
