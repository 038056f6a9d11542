// Connected components of a mesh, by union-find over shared edges, and which of them are underconstrained.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/formation/mesh/arap.h"

namespace muster {

/// Components of a mesh whose triangles are joined by edges. Components that share only a vertex can rotate
/// against each other.
class MeshComponents {
public:
    MeshComponents() = default;
    /// Finds the components.
    explicit MeshComponents(const TriangleMesh& mesh);

    /// Number of components.
    std::int32_t count() const { return count_; }
    /// 1 for every vertex of a component in which fewer than two distinct points are constrained: such a
    /// component can rotate and shrink freely. A vertex that two components share counts for both.
    std::vector<std::uint8_t> underconstrained(const TriangleMesh& mesh, std::span<const std::int32_t> hard,
                                               std::span<const SoftConstraint> soft) const;

private:
    std::vector<std::int32_t> component_;  // Component of each triangle.
    std::int32_t count_ = 0;
};

}  // namespace muster
