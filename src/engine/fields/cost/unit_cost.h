// Unit cost: the cost of one metre, per grid cell and direction (paper eq. 7; SPEC A3). It is
// C = (alpha f + beta + gamma g) / (f T), with the speed f relative to the free speed, the discomfort g, the
// travel speed T of the ground, and the weights of Parameters::Cost. With alpha + beta = 1 open ground costs
// 1 per metre, so that costs are lengths in metres.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Cost of a point or cell that cannot be reached or entered.
inline constexpr float kUnreachableCost = std::numeric_limits<float>::infinity();

/// Unit cost of leaving a cell in each of the four directions [cost per metre]; infinite in walls and towards
/// walls.
struct CellCost {
    float east = 1.0f;   ///< Cost towards the next column.
    float north = 1.0f;  ///< Cost towards the next row.
    float west = 1.0f;   ///< Cost towards the previous column.
    float south = 1.0f;  ///< Cost towards the previous row.

    /// Lets an archive read or write the cost.
    template <class Archive>
    void visit(Archive& archive) {
        archive(east, north, west, south);
    }
};

/// The free point of a cell at a wall: the point nearest to the cell's centre that a character can reach,
/// where that is less than a cell away. A cost field holds the value of this point, so that paths along walls
/// and round corners have their true length.
struct WallNode {
    std::int32_t cell = 0;  ///< Row-major index of the cell.
    float x = 0.0f;         ///< Point along x, from the cell's centre [cells].
    float y = 0.0f;         ///< Point along y, from the cell's centre [cells].
    float normalX = 0.0f;   ///< Unit vector away from the wall; null where the point is the cell's centre.
    float normalY = 0.0f;   ///< Unit vector away from the wall; null where the point is the cell's centre.
    float unit = 0.0f;      ///< Unit cost, the same in all directions; 0 where directions differ.

    /// True for a cell whose centre is blocked between two walls. Such a cell is entered and left over its
    /// open edges only: no line of sight leads through it.
    bool narrow() const { return normalX == 0.0f && normalY == 0.0f && (x != 0.0f || y != 0.0f); }
    /// Lets an archive read or write the node.
    template <class Archive>
    void visit(Archive& archive) {
        archive(cell, x, y, normalX, normalY, unit);
    }
};

/// The unit cost for characters of one radius on all cells of a grid.
struct UnitCost {
    Grid grid;                    ///< The cells.
    double radius = 0.25;         ///< Radius of the characters [m].
    std::vector<CellCost> cells;  ///< Costs per cell, row-major.
    std::vector<WallNode> nodes;  ///< Wall nodes in ascending order of their cells; may be empty.
    /// Lower bound of the cost of a true metre. Edges to wall nodes may hold less, since they are shorter
    /// than a cell.
    float lowest = 1.0f;

    /// True for a cell that no character of this radius can enter.
    bool wall(std::int32_t index) const {
        const CellCost& c = cells[index];
        return c.east >= kUnreachableCost && c.north >= kUnreachableCost && c.west >= kUnreachableCost &&
               c.south >= kUnreachableCost;
    }
    /// Lets an archive read or write the cost.
    template <class Archive>
    void visit(Archive& archive) {
        archive(grid, radius, cells, nodes, lowest);
    }
};

}  // namespace muster
