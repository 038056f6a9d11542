// What tests of the deformation compare with.
#pragma once

#include <span>
#include <vector>

#include "engine/formation/mesh/arap.h"
#include "engine/formation/mesh/rigid_fit.h"

namespace muster::test {

/// One call for the easy case: no state kept.
inline Result<std::vector<Vec2>> deformAsRigidAsPossible(const TriangleMesh& rest,
                                                         std::span<const std::int32_t> hard,
                                                         std::span<const Vec2> targets) {
    ArapSolver solver;
    Status status = solver.setMesh(rest);
    if (status.ok()) status = solver.setConstraints(hard, {});
    std::vector<Vec2> vertices;
    if (status.ok()) status = solver.solve(targets, {}, vertices);
    if (!status.ok()) return status;
    return vertices;
}

/// The as-rigid-as-possible energy: over triangles, the squared edge differences to the best rotation of the
/// rest triangle [m^2].
inline double arapEnergy(const TriangleMesh& rest, std::span<const Vec2> vertices) {
    double sum = 0.0;
    for (const Triangle& t : rest.triangles) {
        std::vector<Vec2> from, to;
        for (const std::int32_t v : t) {
            from.push_back(rest.vertices[v]);
            to.push_back(vertices[v]);
        }
        const Rotation rotation = bestRigidFit(from, to).rotation;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            sum += lengthSquared((to[next] - to[k]) - rotation.apply(from[next] - from[k]));
        }
    }
    return sum;
}

}  // namespace muster::test
