// Neighbours as rows: for each character its neighbours, the direction to them and the gap between bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {

/// A neighbour of a character.
struct Near {
    std::int32_t other = 0;  ///< Its index.
    Vec2 towards;            ///< Unit vector to it.
    double gap = 0.0;        ///< Gap between the two bodies [m], negative where they overlap.
};

/// Rows of neighbours, made from a list of pairs. Memory is reused.
class NearRows {
public:
    /// Makes the rows of all characters. Bodies and positions must live as long as rows are read.
    void build(const CrowdBodies& bodies, std::span<const Vec2> positions,
               std::span<const NeighbourPair> pairs);
    /// The neighbours of a character, in the order of the pairs.
    std::span<const std::int32_t> of(std::int32_t character) const {
        return std::span(other_).subspan(first_[character], first_[character + 1] - first_[character]);
    }
    /// Direction and gap of a neighbour of a character.
    Near near(std::int32_t character, std::int32_t other) const;

private:
    const CrowdBodies* bodies_ = nullptr;  // Bodies of the last build().
    std::span<const Vec2> positions_;
    // Per character: index of its first neighbour in other_; at the end the number of all.
    std::vector<std::size_t> first_;
    std::vector<std::int32_t> other_;
};

}  // namespace muster
