// As-rigid-as-possible deformation in two linear steps (Igarashi, Moscovich and Hughes 2005).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/triangulation.h"
#include "muster/status.h"

namespace muster {

/// A point of the mesh drawn towards a target.
struct SoftConstraint {
    MeshPoint point;      ///< Where on the mesh.
    double weight = 1.0;  ///< > 0, relative to the mesh's own stiffness.
};

/// Step 1 finds a similarity-free shape, then each triangle gets its best rigid copy and step 2
/// joins these. Both systems are factorised once per set of constraints. Parts of the mesh in which fewer
/// than two points are constrained are drawn weakly to the rest shape as the targets place it best.
class ArapSolver {
public:
    /// A solver without a mesh; solving needs setMesh() and setConstraints() first.
    ArapSolver();  ///< Empty.
    ~ArapSolver();
    ArapSolver(ArapSolver&&) noexcept;  ///< Moves.
    ArapSolver& operator=(ArapSolver&&) noexcept;

    /// Takes the rest shape and forgets constraints. Fails where a triangle is degenerate.
    Status setMesh(const TriangleMesh& rest);
    /// Sets which vertices are held hard and which points softly, and factorises; does nothing where
    /// both are as before. Needs at least two distinct constrained points. Fails with InvalidArgument
    /// on a bad index, a vertex named twice or a weight that is not positive.
    Status setConstraints(std::span<const std::int32_t> hard, std::span<const SoftConstraint> soft);
    /// Writes the deformed vertices for targets in the order of the constraints. Hard targets are met
    /// exactly. Allocates nothing after the first call.
    Status solve(std::span<const Vec2> hardTargets, std::span<const Vec2> softTargets,
                 std::vector<Vec2>& vertices);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The rigid placement of `rest` that best fits `vertices` (least squares, equal weights).
Pose bestRigidFit(std::span<const Vec2> rest, std::span<const Vec2> vertices);

}  // namespace muster
