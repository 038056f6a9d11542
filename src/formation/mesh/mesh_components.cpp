#include "formation/mesh/mesh_components.h"

#include <algorithm>
#include <array>

namespace muster {
namespace {

// The root of a triangle's set, halving the way to it.
std::int32_t rootOf(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        std::int32_t& up = parent[i];
        up = parent[up];
        i = up;
    }
    return i;
}

// What is known of a part's constraints: the first point, and whether another lies elsewhere.
struct Held {
    bool any = false;
    bool enough = false;
    Vec2 first;

    void add(Vec2 p, double apart) {
        if (!any)
            first = p;
        else if (distance(first, p) > apart)
            enough = true;
        any = true;
    }
};

}  // namespace

MeshComponents::MeshComponents(const TriangleMesh& mesh) {
    const std::size_t n = mesh.triangles.size();
    std::vector<std::int32_t> parent(n);
    std::vector<std::array<std::int32_t, 3>> sides;  // Both ends of an edge in ascending order, triangle.
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
        const std::int32_t a = rootOf(parent, sides[k - 1][2]);
        const std::int32_t b = rootOf(parent, sides[k][2]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    part_.assign(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
        const auto root = static_cast<std::size_t>(rootOf(parent, static_cast<std::int32_t>(k)));
        part_[k] = root == k ? count_++ : part_[root];
    }
}

std::vector<std::uint8_t> MeshComponents::heldByFewerThanTwo(const TriangleMesh& mesh,
                                                             std::span<const std::int32_t> hard,
                                                             std::span<const SoftConstraint> soft) const {
    const Box box = boundsOf(mesh.vertices);
    const double apart = 1e-9 * (box.width() + box.height());
    std::vector<Held> held(static_cast<std::size_t>(count_));
    std::vector<std::uint8_t> isHard(mesh.vertices.size(), 0);
    for (const std::int32_t v : hard) isHard[v] = 1;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const std::int32_t v : mesh.triangles[k]) {
            const auto vertex = static_cast<std::size_t>(v);
            if (isHard[vertex] != 0) held[part_[k]].add(mesh.vertices[vertex], apart);
        }
    }
    for (const SoftConstraint& s : soft) {
        const Vec2 p = s.point.position(mesh.triangles, mesh.vertices);
        held[part_[s.point.triangle]].add(p, apart);
    }
    std::vector<std::uint8_t> needy(mesh.vertices.size(), 0);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (held[part_[k]].enough) continue;
        for (const std::int32_t v : mesh.triangles[k]) needy[v] = 1;
    }
    return needy;
}

}  // namespace muster
