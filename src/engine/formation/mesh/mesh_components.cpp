#include "engine/formation/mesh/mesh_components.h"

#include <algorithm>
#include <array>
#include <utility>

namespace muster {
namespace {

// The representative of a triangle's set, with path halving (Tarjan and van Leeuwen 1984).
std::int32_t findSet(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        std::int32_t& up = parent[i];
        up = parent[up];
        i = up;
    }
    return i;
}

// The constraints of a component.
struct ConstrainedPoints {
    bool any = false;
    bool distinct = false;  // True where two distinct points are constrained.
    Vec2 first;

    void add(Vec2 p, double apart) {
        if (!any)
            first = p;
        else if (distance(first, p) > apart)
            distinct = true;
        any = true;
    }
};

}  // namespace

MeshComponents::MeshComponents(const TriangleMesh& mesh) {
    const std::size_t n = mesh.triangles.size();
    std::vector<std::int32_t> parent(n);
    std::vector<std::array<std::int32_t, 3>> sides;  // Edges: both ends in ascending order, and the triangle.
    sides.reserve(3 * n);
    for (std::size_t k = 0; k < n; ++k) {
        parent[k] = static_cast<std::int32_t>(k);
        const Triangle& t = mesh.triangles[k];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t a = t[i];
            const std::int32_t b = t[(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(k)});
        }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = 1; k < sides.size(); ++k) {
        if (sides[k][0] != sides[k - 1][0] || sides[k][1] != sides[k - 1][1]) continue;
        const std::int32_t a = findSet(parent, sides[k - 1][2]);
        const std::int32_t b = findSet(parent, sides[k][2]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    component_.assign(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
        const std::int32_t first = findSet(parent, static_cast<std::int32_t>(k));
        component_[k] = std::cmp_equal(first, k) ? count_++ : component_[first];
    }
}

std::vector<std::uint8_t> MeshComponents::underconstrained(const TriangleMesh& mesh,
                                                           std::span<const std::int32_t> hard,
                                                           std::span<const SoftConstraint> soft) const {
    const Box box = boundsOf(mesh.vertices);
    const double apart = 1e-9 * (box.width() + box.height());
    std::vector<ConstrainedPoints> constrained(count_);
    std::vector<std::uint8_t> isHard(mesh.vertices.size(), 0);
    for (const std::int32_t v : hard) isHard[v] = 1;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const std::int32_t v : mesh.triangles[k]) {
            if (isHard[v] != 0) constrained[component_[k]].add(mesh.vertices[v], apart);
        }
    }
    for (const SoftConstraint& s : soft) {
        const Vec2 p = s.point.position(mesh.triangles, mesh.vertices);
        constrained[component_[s.point.triangle]].add(p, apart);
    }
    std::vector<std::uint8_t> weak(mesh.vertices.size(), 0);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (constrained[component_[k]].distinct) continue;
        for (const std::int32_t v : mesh.triangles[k]) weak[v] = 1;
    }
    return weak;
}

}  // namespace muster
