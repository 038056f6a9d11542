// As-rigid-as-possible deformation in two linear steps (Igarashi, Moscovich and Hughes 2005; paper
// section 4.1).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/geometry/triangulation.h"
#include "muster/status.h"

namespace muster {

/// A soft constraint: a point of the mesh that is drawn towards a target.
struct SoftConstraint {
    MeshPoint point;      ///< Point of the mesh.
    double weight = 1.0;  ///< Weight relative to the mesh's own stiffness, above 0.
};

/// Step 1 finds a shape that is free up to similarities; then each triangle is rotated to fit it best, and
/// step 2 joins the edges of the rotated triangles. Both systems are factorised once per set of constraints.
/// Components of the mesh in which fewer than two points are constrained are drawn weakly to the rest shape,
/// placed to fit the targets.
class ArapSolver {
public:
    /// A solver without a mesh; solve() needs setMesh() and setConstraints() first.
    ArapSolver();
    ~ArapSolver();
    ArapSolver(ArapSolver&&) noexcept;
    ArapSolver& operator=(ArapSolver&&) noexcept;

    /// Fails with InvalidArgument, naming the vertex or triangle, where a triangle is degenerate or runs
    /// clockwise, or a vertex is unused or not finite.
    static Status checkMesh(const TriangleMesh& rest);
    /// Sets the rest shape and drops the constraints. Fails as checkMesh().
    Status setMesh(const TriangleMesh& rest);
    /// Sets hard constraints (vertices) and soft ones and factorises; does nothing where both are unchanged.
    /// Needs at least two distinct constrained points. Fails with InvalidArgument on a bad index, a vertex
    /// that is constrained twice or a weight that is not positive.
    Status setConstraints(std::span<const std::int32_t> hard, std::span<const SoftConstraint> soft);
    /// Writes the deformed vertices for targets [m] in the order of the constraints. Hard targets are met
    /// exactly. Allocates nothing after the first call.
    Status solve(std::span<const Vec2> hardTargets, std::span<const Vec2> softTargets,
                 std::vector<Vec2>& vertices);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
