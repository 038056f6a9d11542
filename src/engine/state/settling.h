// Where a group settles.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// Whether the mesh of a group rests, and how far beside it its places settle.
struct Settling {
    Vec2 centre;                  ///< Mean of its targets in the last step [m].
    std::uint32_t restSteps = 0;  ///< Steps for which that has not moved.
    Vec2 shift;                   ///< Shift of its targets, out of those of other groups [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(centre, restSteps, shift);
    }
};

}  // namespace muster
