#include "people/bodies/mesh_builder.h"

#include <algorithm>

namespace muster::bodies {

std::uint32_t MeshBuilder::add(Vec3 position, const Stuff& stuff) {
    BodyVertex vertex;
    vertex.position = flipped(position);
    vertex.colour = stuff.colour;
    vertex.region = stuff.region;
    vertices_.push_back(vertex);
    parts_.push_back(stuff.part);
    return static_cast<std::uint32_t>(vertices_.size() - 1);
}

Ring MeshBuilder::add(std::span<const Vec3> points, const Stuff& stuff) {
    Ring ring;
    for (const Vec3& p : points) ring.push_back(add(p, stuff));
    return ring;
}

Vec3 MeshBuilder::middle(std::span<const std::uint32_t> ring) const {
    Vec3 sum;
    for (std::uint32_t v : ring) sum += at(v);
    return sum * (1.0f / static_cast<float>(ring.size()));
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (mirrored_) std::swap(b, c);
    triangles_.push_back({a, b, c});
}

void MeshBuilder::bridge(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to,
                         bool closed) {
    const std::size_t n = from.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
        const std::size_t j = (i + 1) % n;
        // The quad is split along its shorter diagonal, which bends the surface less.
        if (distance(at(from[i]), at(to[j])) <= distance(at(from[j]), at(to[i]))) {
            triangle(from[i], from[j], to[j]);
            triangle(from[i], to[j], to[i]);
        } else {
            triangle(from[i], from[j], to[i]);
            triangle(from[j], to[j], to[i]);
        }
    }
}

void MeshBuilder::cap(const Ring& ring, Vec3 tip, const Stuff& stuff, bool left) {
    const std::uint32_t t = add(tip, stuff);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
        left ? triangle(a, b, t) : triangle(b, a, t);
    }
}

void MeshBuilder::findNormals() {
    // The length of the cross product is twice the area, so normals are weighted by area.
    for (const auto& [a, b, c] : triangles_) {
        const Vec3 origin = vertices_[a].position;
        const Vec3 normal = cross(vertices_[b].position - origin, vertices_[c].position - origin);
        for (std::uint32_t v : {a, b, c}) vertices_[v].normal += normal;
    }
    for (BodyVertex& vertex : vertices_) vertex.normal = normalized(vertex.normal, {0.0f, 0.0f, 1.0f});
}

BodyMesh MeshBuilder::finish() {
    findNormals();
    for (std::size_t v = 0; v < vertices_.size(); ++v) setWeights(parts_[v], vertices_[v]);
    const auto regionOf = [this](const auto& corners) {
        return static_cast<std::size_t>(vertices_[corners[0]].region);
    };
    std::stable_sort(triangles_.begin(), triangles_.end(),
                     [&](const auto& a, const auto& b) { return regionOf(a) < regionOf(b); });
    BodyMesh mesh;
    for (const auto& corners : triangles_) {
        mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
        mesh.regionBegin[regionOf(corners) + 1] = mesh.indices.size();
    }
    for (std::size_t r = 1; r < mesh.regionBegin.size(); ++r)
        mesh.regionBegin[r] = std::max(mesh.regionBegin[r], mesh.regionBegin[r - 1]);
    mesh.vertices = std::move(vertices_);
    return mesh;
}

}  // namespace muster::bodies
