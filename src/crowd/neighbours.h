// Who is near whom: a sorted cell list.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_list.h"

namespace muster {

/// Two characters close to each other, `a` < `b`.
struct NearPair {
    std::int32_t a = 0;  ///< Index into the positions given.
    std::int32_t b = 0;  ///< Index into the positions given.
};

/// Who was near whom, and where.
struct KnownPairs {
    std::span<const NearPair> pairs;  ///< All pairs nearer than `reach`.
    std::span<const Vec2> at;         ///< Positions then [m].
    double reach = 0.0;               ///< [m]; 0 where nothing is known.
};

/// Finds close pairs in time proportional to their number; reuses its memory.
class NeighbourGrid {
public:
    /// Writes to `pairs` all pairs nearer than `reach` [m] > 0, in a fixed order that depends on the
    /// positions and indices only.
    void findPairs(std::span<const Vec2> positions, double reach, std::vector<NearPair>& pairs);

private:
    CellList cells_;
};

}  // namespace muster
