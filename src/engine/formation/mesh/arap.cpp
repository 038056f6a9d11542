#include "engine/formation/mesh/arap.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/formation/mesh/mesh_components.h"
#include "engine/formation/mesh/rigid_fit.h"
#include "engine/formation/mesh/sparse_ldlt.h"

namespace muster {
namespace {

// Weight at which underconstrained components are drawn to the placement of the rest shape that fits all
// targets best, so that both systems are positive definite.
constexpr double kWeakPull = 1e-4;

std::array<Vec2, 3> corners(const Triangle& t, std::span<const Vec2> vertices) {
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
}

// Constants of a triangle at rest.
struct RestTriangle {
    std::array<Vec2, 3> spoke;  // Vectors from the centre to each corner, conjugate.
    std::array<Vec2, 3> edge;   // Vectors from each corner to the next.
};

RestTriangle restTriangle(const std::array<Vec2, 3>& c) {
    const Vec2 mean = (c[0] + c[1] + c[2]) / 3.0;
    return {{complexConjugate(c[0] - mean), complexConjugate(c[1] - mean), complexConjugate(c[2] - mean)},
            {c[1] - c[0], c[2] - c[1], c[0] - c[2]}};
}

// The rotation that fits the rest triangle best to the given corners (least squares).
Vec2 bestRotation(const RestTriangle& rest, const std::array<Vec2, 3>& now) {
    const Vec2 mean = (now[0] + now[1] + now[2]) / 3.0;
    Vec2 sum;
    for (std::size_t k = 0; k < 3; ++k) sum += complexProduct(rest.spoke[k], now[k] - mean);
    const double l = length(sum);
    return l > 1e-300 ? sum / l : Vec2{1.0, 0.0};
}

bool isSame(const SoftConstraint& a, const SoftConstraint& b) {
    return a.point.triangle == b.point.triangle && a.point.weight == b.point.weight && a.weight == b.weight;
}

}  // namespace

struct ArapSolver::Impl {
    // A matrix entry in the column of a hard constraint, which is moved to the right side.
    struct Coupling {
        std::int32_t row;     // Index of the free vertex.
        std::int32_t column;  // Index of the hard constraint.
        Vec2 factor;          // Complex factor.
    };
    // A vertex of an underconstrained component.
    struct Pull {
        std::int32_t vertex;
        double weight;
    };

    TriangleMesh rest;
    std::vector<RestTriangle> restTriangles;
    MeshComponents components;
    std::vector<std::int32_t> hard;
    std::vector<SoftConstraint> soft;
    bool ready = false;

    std::vector<std::int32_t> freeIndex;  // Row of each vertex; -1 - k for the k-th hard constraint.
    std::int32_t freeCount = 0;
    std::vector<Pull> pulls;
    SparseLdlt similarity;
    SparseLdlt edges;
    std::vector<Coupling> similarityKnown;
    std::vector<Coupling> edgesKnown;
    std::vector<SparseEntry> entries;

    std::vector<Vec2> restPoints;   // Rest points of hard, then soft constraints [m].
    std::vector<Vec2> targets;      // Targets of hard, then soft constraints, relative to the first [m].
    std::vector<double> right;      // Right side of step 1: x and y of each free vertex.
    std::vector<Vec2> rightPoints;  // Right side of step 2.

    Status check(std::span<const std::int32_t> newHard, std::span<const SoftConstraint> newSoft);
    void indexVertices();
    void findPulls();
    bool factorise();
    void addSimilarity(std::int32_t a, std::int32_t b, Vec2 factor);
    void addEdge(std::int32_t a, std::int32_t b, double factor);
    void addSoft(bool forSimilarity);
    void firstStep(std::vector<Vec2>& vertices);
    void addTriangles(const std::vector<Vec2>& vertices);
    void secondStep(std::vector<Vec2>& vertices);
    Pose placement() const;
};

Status ArapSolver::Impl::check(std::span<const std::int32_t> newHard,
                               std::span<const SoftConstraint> newSoft) {
    freeIndex.assign(rest.vertices.size(), 0);
    for (const std::int32_t v : newHard) {
        if (v < 0 || std::cmp_greater_equal(v, rest.vertices.size()))
            return invalidArgument("hard constraint on vertex " + std::to_string(v) +
                                   ", which the mesh does not have");
        if (freeIndex[v] != 0)
            return invalidArgument("vertex " + std::to_string(v) + " is constrained twice");
        freeIndex[v] = 1;
    }
    for (std::size_t k = 0; k < newSoft.size(); ++k) {
        const SoftConstraint& s = newSoft[k];
        if (s.point.triangle < 0 || std::cmp_greater_equal(s.point.triangle, rest.triangles.size()))
            return invalidArgument("soft constraint " + std::to_string(k) + " lies on triangle " +
                                   std::to_string(s.point.triangle) + ", which the mesh does not have");
        const auto& w = s.point.weight;
        if (!(s.weight > 0.0) || !std::isfinite(s.weight) || !std::isfinite(w[0] + w[1] + w[2]))
            return invalidArgument("soft constraint " + std::to_string(k) +
                                   " has a weight that is not positive and finite");
    }
    restPoints.clear();
    for (const std::int32_t v : newHard) restPoints.push_back(rest.vertices[v]);
    for (const SoftConstraint& s : newSoft)
        restPoints.push_back(s.point.position(rest.triangles, rest.vertices));
    const Box box = boundsOf(rest.vertices);
    const double apart = 1e-9 * (box.width() + box.height());
    for (const Vec2 p : restPoints)
        if (distance(p, restPoints.front()) > apart) return {};
    return invalidArgument("fewer than two distinct points of the mesh are constrained");
}

void ArapSolver::Impl::indexVertices() {
    freeIndex.assign(rest.vertices.size(), 0);
    for (std::size_t k = 0; k < hard.size(); ++k) freeIndex[hard[k]] = -1 - static_cast<std::int32_t>(k);
    freeCount = 0;
    for (std::int32_t& index : freeIndex)
        if (index == 0) index = freeCount++;
}

void ArapSolver::Impl::findPulls() {
    pulls.clear();
    const auto weak = components.underconstrained(rest, hard, soft);
    for (std::size_t v = 0; v < weak.size(); ++v)
        if (weak[v] != 0 && freeIndex[v] >= 0) pulls.push_back({static_cast<std::int32_t>(v), kWeakPull});
}

// Adds a complex entry of the Hermitian system, which is written as a real one of twice the size.
void ArapSolver::Impl::addSimilarity(std::int32_t a, std::int32_t b, Vec2 factor) {
    const std::int32_t row = freeIndex[a];
    const std::int32_t column = freeIndex[b];
    if (row < 0) return;
    if (column < 0) {
        similarityKnown.push_back({row, -1 - column, factor});
        return;
    }
    entries.emplace_back(2 * row, 2 * column, factor.x);
    entries.emplace_back(2 * row, 2 * column + 1, -factor.y);
    entries.emplace_back(2 * row + 1, 2 * column, factor.y);
    entries.emplace_back(2 * row + 1, 2 * column + 1, factor.x);
}

void ArapSolver::Impl::addEdge(std::int32_t a, std::int32_t b, double factor) {
    const std::int32_t row = freeIndex[a];
    const std::int32_t column = freeIndex[b];
    if (row < 0) return;
    if (column < 0)
        edgesKnown.push_back({row, -1 - column, {factor, 0.0}});
    else
        entries.emplace_back(row, column, factor);
}

void ArapSolver::Impl::addSoft(bool forSimilarity) {
    for (const SoftConstraint& s : soft) {
        const Triangle& t = rest.triangles[s.point.triangle];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const double factor = s.weight * s.point.weight[i] * s.point.weight[j];
                if (factor == 0.0) continue;
                if (forSimilarity)
                    addSimilarity(t[i], t[j], {factor, 0.0});
                else
                    addEdge(t[i], t[j], factor);
            }
        }
    }
    for (const Pull& pull : pulls) {
        if (forSimilarity)
            addSimilarity(pull.vertex, pull.vertex, {pull.weight, 0.0});
        else
            addEdge(pull.vertex, pull.vertex, pull.weight);
    }
}

// Igarashi et al., equations 1 to 6 (similarity) and 12 to 17 (edges).
bool ArapSolver::Impl::factorise() {
    entries.clear();
    similarityKnown.clear();
    edgesKnown.clear();
    for (const Triangle& t : rest.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            // The corner c relative to the edge a b: c = (1 - z) a + z b, in complex numbers.
            const std::array<std::int32_t, 3> v{t[(k + 1) % 3], t[(k + 2) % 3], t[k]};
            const Vec2 edge = rest.vertices[v[1]] - rest.vertices[v[0]];
            const Vec2 z = complexProduct(complexConjugate(edge), rest.vertices[v[2]] - rest.vertices[v[0]]) /
                           lengthSquared(edge);
            const std::array<Vec2, 3> row{Vec2{z.x - 1.0, z.y}, -z, Vec2{1.0, 0.0}};
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    addSimilarity(v[i], v[j], complexProduct(complexConjugate(row[i]), row[j]));
        }
    }
    addSoft(true);
    if (!similarity.factorise(2 * freeCount, entries)) return false;
    entries.clear();
    for (const Triangle& t : rest.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = t[k];
            const std::int32_t b = t[(k + 1) % 3];
            addEdge(a, a, 1.0);
            addEdge(b, b, 1.0);
            addEdge(a, b, -1.0);
            addEdge(b, a, -1.0);
        }
    }
    addSoft(false);
    return edges.factorise(freeCount, entries);
}

// The placement of the rest shape that fits the targets best.
Pose ArapSolver::Impl::placement() const {
    return bestRigidFit(restPoints, targets);
}

void ArapSolver::Impl::firstStep(std::vector<Vec2>& vertices) {
    std::fill(right.begin(), right.end(), 0.0);
    const auto add = [&](std::int32_t vertex, Vec2 value) {
        const std::int32_t row = freeIndex[vertex];
        if (row < 0) return;
        right[2 * row] += value.x;
        right[2 * row + 1] += value.y;
    };
    for (const Coupling& c : similarityKnown) {
        const Vec2 value = complexProduct(c.factor, targets[c.column]);
        right[2 * c.row] -= value.x;
        right[2 * c.row + 1] -= value.y;
    }
    for (std::size_t k = 0; k < soft.size(); ++k) {
        const Triangle& t = rest.triangles[soft[k].point.triangle];
        for (std::size_t i = 0; i < 3; ++i)
            add(t[i], targets[hard.size() + k] * (soft[k].weight * soft[k].point.weight[i]));
    }
    if (!pulls.empty()) {
        const Pose pose = placement();
        for (const Pull& pull : pulls) add(pull.vertex, pose.apply(rest.vertices[pull.vertex]) * pull.weight);
    }
    similarity.solve(right);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::int32_t row = freeIndex[v];
        vertices[v] = row < 0 ? targets[-1 - row] : Vec2{right[2 * row], right[2 * row + 1]};
    }
}

// Adds the edges of each triangle, rotated to fit the result of step 1 best.
void ArapSolver::Impl::addTriangles(const std::vector<Vec2>& vertices) {
    for (std::size_t n = 0; n < rest.triangles.size(); ++n) {
        const Triangle& t = rest.triangles[n];
        const RestTriangle& triangle = restTriangles[n];
        const Vec2 rotation = bestRotation(triangle, corners(t, vertices));
        std::array<Vec2, 3> edge;
        for (std::size_t k = 0; k < 3; ++k) edge[k] = complexProduct(rotation, triangle.edge[k]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t row = freeIndex[t[k]];
            if (row < 0) continue;
            Vec2& sum = rightPoints[row];
            // Sums are in the order of edges: the first corner has its outgoing edge before its incoming one.
            if (k == 0)
                sum = (sum - edge[0]) + edge[2];
            else
                sum = (sum + edge[k - 1]) - edge[k];
        }
    }
}

void ArapSolver::Impl::secondStep(std::vector<Vec2>& vertices) {
    std::fill(rightPoints.begin(), rightPoints.end(), Vec2{});
    const auto add = [&](std::int32_t row, Vec2 value) {
        if (row >= 0) rightPoints[row] += value;
    };
    addTriangles(vertices);
    for (const Coupling& c : edgesKnown) add(c.row, targets[c.column] * -c.factor.x);
    for (std::size_t k = 0; k < soft.size(); ++k) {
        const Triangle& t = rest.triangles[soft[k].point.triangle];
        for (std::size_t i = 0; i < 3; ++i)
            add(freeIndex[t[i]], targets[hard.size() + k] * (soft[k].weight * soft[k].point.weight[i]));
    }
    if (!pulls.empty()) {
        const Pose pose = placement();
        for (const Pull& pull : pulls)
            add(freeIndex[pull.vertex], pose.apply(rest.vertices[pull.vertex]) * pull.weight);
    }
    edges.solve(rightPoints);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::int32_t row = freeIndex[v];
        vertices[v] = row < 0 ? targets[-1 - row] : rightPoints[row];
    }
}

ArapSolver::ArapSolver() : impl_(std::make_unique<Impl>()) {}
ArapSolver::~ArapSolver() = default;
ArapSolver::ArapSolver(ArapSolver&&) noexcept = default;
ArapSolver& ArapSolver::operator=(ArapSolver&&) noexcept = default;

Status ArapSolver::checkMesh(const TriangleMesh& rest) {
    const auto count = static_cast<std::int32_t>(rest.vertices.size());
    if (rest.triangles.empty()) return invalidArgument("the mesh has no triangles");
    for (std::size_t v = 0; v < rest.vertices.size(); ++v)
        if (!isFinite(rest.vertices[v]))
            return invalidArgument("vertex " + std::to_string(v) + " is not finite");
    std::vector<std::uint8_t> used(rest.vertices.size(), 0);
    for (std::size_t k = 0; k < rest.triangles.size(); ++k) {
        const Triangle& t = rest.triangles[k];
        for (const std::int32_t v : t)
            if (v < 0 || v >= count)
                return invalidArgument("triangle " + std::to_string(k) + " names vertex " +
                                       std::to_string(v) + ", which the mesh does not have");
        const auto c = corners(t, rest.vertices);
        const double longest = std::max(
            {lengthSquared(c[1] - c[0]), lengthSquared(c[2] - c[1]), lengthSquared(c[0] - c[2])});
        if (!(cross(c[1] - c[0], c[2] - c[0]) > 1e-10 * longest))
            return invalidArgument("triangle " + std::to_string(k) + " is degenerate or runs clockwise");
        for (const std::int32_t v : t) used[v] = 1;
    }
    for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v] == 0) return invalidArgument("vertex " + std::to_string(v) + " belongs to no triangle");
    return {};
}

Status ArapSolver::setMesh(const TriangleMesh& rest) {
    if (const Status valid = checkMesh(rest); !valid.ok()) return valid;
    impl_->rest = rest;
    impl_->components = MeshComponents(rest);
    impl_->ready = false;
    impl_->hard.clear();
    impl_->soft.clear();
    impl_->restTriangles.clear();
    for (const Triangle& t : rest.triangles)
        impl_->restTriangles.push_back(restTriangle(corners(t, rest.vertices)));
    return {};
}

Status ArapSolver::setConstraints(std::span<const std::int32_t> hard, std::span<const SoftConstraint> soft) {
    Impl& s = *impl_;
    if (s.ready && std::equal(hard.begin(), hard.end(), s.hard.begin(), s.hard.end()) &&
        std::equal(soft.begin(), soft.end(), s.soft.begin(), s.soft.end(), isSame))
        return {};
    s.ready = false;
    if (s.rest.triangles.empty()) return invalidArgument("constraints were set before a mesh");
    const Status checked = s.check(hard, soft);
    if (!checked.ok()) return checked;
    s.hard.assign(hard.begin(), hard.end());
    s.soft.assign(soft.begin(), soft.end());
    s.indexVertices();
    s.findPulls();
    if (!s.factorise())
        return invalidArgument("the constrained mesh cannot be factorised: its triangles are too thin");
    s.right.assign(2 * s.freeCount, 0.0);
    s.rightPoints.assign(s.freeCount, {});
    s.targets.resize(hard.size() + soft.size());
    s.ready = true;
    return {};
}

Status ArapSolver::solve(std::span<const Vec2> hardTargets, std::span<const Vec2> softTargets,
                         std::vector<Vec2>& vertices) {
    Impl& s = *impl_;
    if (!s.ready) return invalidArgument("no constraints are set");
    if (hardTargets.size() != s.hard.size() || softTargets.size() != s.soft.size())
        return invalidArgument("found " + std::to_string(hardTargets.size()) + " hard and " +
                               std::to_string(softTargets.size()) + " soft targets, expected " +
                               std::to_string(s.hard.size()) + " and " + std::to_string(s.soft.size()));
    // Solved relative to the first target, so that far from the origin no digits are lost.
    const Vec2 origin = hardTargets.empty() ? softTargets[0] : hardTargets[0];
    std::size_t k = 0;
    for (const Vec2 target : hardTargets) s.targets[k++] = target - origin;
    for (const Vec2 target : softTargets) s.targets[k++] = target - origin;
    for (std::size_t n = 0; n < k; ++n)
        if (!isFinite(s.targets[n])) return invalidArgument("target " + std::to_string(n) + " is not finite");
    vertices.resize(s.rest.vertices.size());
    s.firstStep(vertices);
    s.secondStep(vertices);
    for (Vec2& v : vertices) v += origin;
    for (std::size_t n = 0; n < hardTargets.size(); ++n) vertices[s.hard[n]] = hardTargets[n];
    return {};
}

}  // namespace muster
