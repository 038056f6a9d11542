// Meshes from rings of points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "character/bodies/body.h"

namespace muster::bodies {

using Ring = std::vector<std::uint32_t>;  ///< Indices of vertices, in order round an axis.

/// Which way vertices move with the joints.
enum class Part : std::uint8_t { Trunk, Leg, Arm, Shoe, Head };

/// What new vertices are made of.
struct Stuff {
    BodyRegion region = BodyRegion::Skin;
    Part part = Part::Trunk;
    Vec3 colour;  ///< Linear light.
};

/// Collects vertices and triangles. Triangles that share vertices are shaded as one smooth surface.
class MeshBuilder {
public:
    /// While true all that is said is meant for the other side of the body: y is negated, triangles turn
    /// round.
    void setMirrored(bool mirrored) { mirrored_ = mirrored; }

    /// One vertex.
    std::uint32_t add(Vec3 position, const Stuff& stuff);
    /// One vertex for each point.
    Ring add(std::span<const Vec3> points, const Stuff& stuff);
    /// Where a vertex is.
    Vec3 at(std::uint32_t vertex) const { return flipped(vertices_[vertex].position); }
    /// The middle of a ring.
    Vec3 middle(std::span<const std::uint32_t> ring) const;

    /// A triangle, anticlockwise seen from outside.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Joins two rows of equal size; seen from outside, `to` lies to the left of the way along `from`. Where
    /// the rows are closed the last vertices are joined with the first.
    void bridge(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to, bool closed = true);
    /// Closes a ring by a point to the left of the way round it, or to its right.
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

/// Sets joints and weights of a vertex by where it is and what it belongs to.
void setWeights(Part part, BodyVertex& vertex);

}  // namespace muster::bodies
