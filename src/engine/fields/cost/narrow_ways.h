// Cells of narrow ways: the centre is blocked, but a character can stand in the cell and go on from there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/cost/gap_index.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/ground/environment/environment.h"

namespace muster {

/// A cell between two walls, entered at a point off its centre; or a free cell next to a wall so thin that
/// the next cell is free too.
struct NarrowCell {
    std::int32_t cell = 0;  ///< Row-major index of the ground cell.
    float x = 0.0f;         ///< Point along x, from the cell's centre [cells]; null for a free cell.
    float y = 0.0f;         ///< Point along y, from the cell's centre [cells]; null for a free cell.
    /// Bit k is set where a walk of at most three bends leads to the neighbour at kNarrowSteps[k].
    std::uint8_t open = 0;
    /// True for a free cell, which keeps the node that the raster gives it.
    bool keepsNode() const { return x == 0.0f && y == 0.0f; }
    /// Equal in all parts.
    friend bool operator==(const NarrowCell&, const NarrowCell&) = default;
};

/// The neighbours of a cell in the order of CellCost: east, north, west, south.
inline constexpr Cell kNarrowSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

/// All narrow cells of the static ground for characters of one radius. A raster of clearances at cell centres
/// shows a narrow way only where centres lie in it; here points and steps are found by exact geometry, so
/// that a way is open wherever it lies between the centres, and no step leads through a wall or a closed gap.
class NarrowWays {
public:
    /// Empties it, for characters of `radius` [m]; update() of the whole world must follow.
    void reset(double radius);
    /// Finds the narrow cells in the changed cells of `area` again. `gaps` holds the closed gaps.
    void update(const Environment& environment, const GapIndex& gaps, const CellRect& area);
    /// All narrow cells, in ascending order.
    std::span<const NarrowCell> cells() const { return cells_; }
    /// Narrow cells with indices from `first` to `last`.
    std::span<const NarrowCell> between(std::int32_t first, std::int32_t last) const;
    /// The narrow cell of this index, or null.
    const NarrowCell* find(std::int32_t cell) const;

private:
    double radius_ = 0.0;  // Radius of the characters [m].
    std::vector<NarrowCell> cells_;
};

}  // namespace muster
