#include <algorithm>
#include <limits>

#include "engine/geometry/triangulation.h"

namespace muster {
namespace {

struct DirectedEdge {
    std::int32_t from;
    std::int32_t to;
    std::int32_t triangle;
    friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

std::vector<DirectedEdge> directedEdges(const std::vector<Triangle>& triangles) {
    std::vector<DirectedEdge> edges;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.push_back({triangles[i][k], triangles[i][(k + 1) % 3], static_cast<std::int32_t>(i)});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

// Index of the edge, or -1.
std::ptrdiff_t findEdge(const std::vector<DirectedEdge>& edges, std::int32_t from, std::int32_t to) {
    const auto at = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{from, to, -1});
    return at != edges.end() && at->from == from && at->to == to ? at - edges.begin() : -1;
}

// The boundary edge that follows boundary edge `at`, found by rotating about its end through the triangles,
// so that loops which touch in one vertex stay separate. -1 where the mesh is not a manifold.
std::ptrdiff_t nextBoundary(const std::vector<Triangle>& triangles, const std::vector<DirectedEdge>& edges,
                            std::ptrdiff_t at) {
    const std::int32_t pivot = edges[at].to;
    for (std::size_t k = 0; k <= triangles.size(); ++k) {
        const Triangle& t = triangles[edges[at].triangle];
        const auto corner = std::find(t.begin(), t.end(), pivot) - t.begin();
        const std::int32_t apex = t[(corner + 1) % 3];
        const std::ptrdiff_t opposite = findEdge(edges, apex, pivot);
        if (opposite < 0) return findEdge(edges, pivot, apex);
        at = opposite;
    }
    return -1;
}

// Fraction of the segment a-b at which it is nearest to p.
double shareOnSegment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 along = b - a;
    const double squared = lengthSquared(along);
    return squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
}

// Finds the nearest point of a triangle's boundary as barycentric weights; returns the squared distance.
double nearestOnBoundary(const std::array<Vec2, 3>& corner, Vec2 p, std::array<double, 3>& weight) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3;
        const double t = shareOnSegment(corner[k], corner[l], p);
        const double squared = lengthSquared(lerp(corner[k], corner[l], t) - p);
        if (squared >= best) continue;
        best = squared;
        weight = {0.0, 0.0, 0.0};
        weight[k] = 1.0 - t;
        weight[l] = t;
    }
    return best;
}

// Weight below which a point is surely outside: on the boundary only rounding makes weights negative.
constexpr double kSurelyOutside = -1e-3;
// Twice the area below which a triangle is thin, in squares of its longest side.
constexpr double kThin = 1e-4;

}  // namespace

double squaredDistance(const std::array<Vec2, 3>& corner, Vec2 p, std::array<double, 3>& weight) {
    weight = barycentric(corner[0], corner[1], corner[2], p);
    const bool inside = weight[0] >= 0.0 && weight[1] >= 0.0 && weight[2] >= 0.0 &&
                        cross(corner[1] - corner[0], corner[2] - corner[0]) != 0.0;
    return inside ? 0.0 : nearestOnBoundary(corner, p, weight);
}

bool holds(const std::array<Vec2, 3>& corner, Vec2 p, std::array<double, 3>& weight) {
    const auto& [a, b, c] = corner;
    const double whole = cross(b - a, c - a);
    const double size = std::max({lengthSquared(b - a), lengthSquared(c - b), lengthSquared(a - c)});
    if (whole > kThin * size) {
        const double least = kSurelyOutside * whole;
        if (cross(b - p, c - p) < least || cross(c - p, a - p) < least || cross(a - p, b - p) < least)
            return false;
    }
    return squaredDistance(corner, p, weight) == 0.0;
}

std::array<double, 3> barycentric(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
    const double whole = cross(b - a, c - a);
    const double size = std::max({lengthSquared(b - a), lengthSquared(c - b), lengthSquared(a - c)});
    if (std::fabs(whole) <= 1e-14 * size) {
        std::array<double, 3> weight{1.0, 0.0, 0.0};
        nearestOnBoundary({a, b, c}, p, weight);
        return weight;
    }
    const double u = cross(b - p, c - p) / whole;
    const double v = cross(c - p, a - p) / whole;
    return {u, v, 1.0 - u - v};
}

std::vector<std::vector<std::int32_t>> boundaryLoops(const TriangleMesh& mesh) {
    const std::vector<DirectedEdge> edges = directedEdges(mesh.triangles);
    std::vector<char> used(edges.size(), 0);
    std::vector<std::vector<std::int32_t>> loops;
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (used[start] || findEdge(edges, edges[start].to, edges[start].from) >= 0) continue;
        std::vector<std::int32_t>& loop = loops.emplace_back();
        auto at = static_cast<std::ptrdiff_t>(start);
        while (at >= 0 && !used[at]) {
            used[at] = 1;
            loop.push_back(edges[at].from);
            at = nextBoundary(mesh.triangles, edges, at);
        }
    }
    return loops;
}

MeshPoint locate(const std::vector<Triangle>& triangles, const std::vector<Vec2>& vertices, Vec2 p) {
    MeshPoint best;
    double bestSquared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::array<Vec2, 3> corner{vertices[triangles[i][0]], vertices[triangles[i][1]],
                                         vertices[triangles[i][2]]};
        std::array<double, 3> weight;
        const double squared = squaredDistance(corner, p, weight);
        if (squared >= bestSquared) continue;
        bestSquared = squared;
        best = {static_cast<std::int32_t>(i), weight};
        if (squared == 0.0) break;
    }
    return best;
}

}  // namespace muster
