// Room that the places of a group make for large bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// How far the places of a group stand off their formation, because some who hold them are large. Empty where
/// all are alike.
struct PlaceRoom {
    std::uint64_t key = 0;     ///< Hash of what `wanted` was found for.
    std::vector<Vec2> wanted;  ///< Of each place, in the axes of the rest shape [m].
    std::vector<Vec2> given;   ///< The same now; it goes towards `wanted` [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(key, wanted, given);
    }
};

}  // namespace muster
