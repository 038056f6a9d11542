// Which parts of a mesh hang together, and which of them constraints hold.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formation/mesh/arap.h"

namespace muster {

/// Parts of a mesh joined by edges: parts that touch in one vertex only can turn against each other.
class MeshComponents {
public:
    MeshComponents() = default;
    /// Finds the parts.
    explicit MeshComponents(const TriangleMesh& mesh);

    /// Number of parts.
    std::int32_t count() const { return count_; }
    /// 1 for every vertex of a part in which fewer than two distinct points are constrained: such a part
    /// could still turn and shrink. A vertex shared by two parts counts for both.
    std::vector<std::uint8_t> heldByFewerThanTwo(const TriangleMesh& mesh, std::span<const std::int32_t> hard,
                                                 std::span<const SoftConstraint> soft) const;

private:
    std::vector<std::int32_t> part_;  ///< Of each triangle.
    std::int32_t count_ = 0;
};

}  // namespace muster
