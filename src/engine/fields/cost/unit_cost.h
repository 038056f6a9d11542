// Unit cost: the cost of one metre, per grid cell and direction (paper eq. 7; SPEC A3).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/grid.h"
#include "muster/parameters.h"

namespace muster {

/// Cost of what cannot be reached or entered.
inline constexpr float kUnreachableCost = std::numeric_limits<float>::infinity();

/// Weights and thresholds of the unit cost C = (alpha f + beta + gamma g) / (f T), with the speed f relative
/// to the free speed, the discomfort g and the travel speed T of the ground. With alpha + beta = 1 open
/// ground costs 1 per metre, so that costs are lengths in metres.
struct UnitCostDef {
    /// Weight of path length [1/m], >= 0.
    double alpha = Parameters::Cost{}.alpha;
    /// Weight of travel time [1/m], >= 0; alpha + beta > 0.
    double beta = Parameters::Cost{}.beta;
    /// Weight of discomfort, >= 0.
    double gamma = Parameters::Cost{}.gamma;
    /// Whether a dense crowd lowers the speed f.
    bool density = Parameters::Density{}.enabled;
    /// Whether moving obstacles cause discomfort.
    bool discomfort = Parameters::Discomfort{}.enabled;
    /// Speed of a character on open ground [m/s], > 0.
    double freeSpeed = Parameters::Character{}.maxSpeed;
    /// Density up to which f = 1 [1/m^2], >= 0.
    double densityMin = Parameters::Density{}.min;
    /// Density from which on f is the flow speed [1/m^2], > densityMin.
    double densityMax = Parameters::Density{}.max;
    /// Distance ahead at which the density is read [m], >= 0.
    double lookAhead = Parameters::Density{}.lookAhead;
    /// Lower bound of f, > 0.
    double minSpeed = Parameters::Cost{}.minSpeed;
    /// Time for which moving obstacles are predicted [s], >= 0.
    double discomfortTime = Parameters::Discomfort{}.time;
    /// Distance from the predicted obstacle at which g falls to 0 [m], > 0.
    double discomfortRange = Parameters::Discomfort{}.range;
    /// Value of g on the obstacle itself, now; >= 0.
    double discomfortGain = Parameters::Discomfort{}.gain;
};

/// Unit cost of leaving a cell in each of the four directions [cost per metre]; infinite in walls and towards
/// walls.
struct CellCost {
    float east = 1.0f;   ///< Towards the next column.
    float north = 1.0f;  ///< Towards the next row.
    float west = 1.0f;   ///< Towards the previous column.
    float south = 1.0f;  ///< Towards the previous row.

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
    float x = 0.0f;         ///< The point, from the cell's centre [cells].
    float y = 0.0f;         ///< The point, from the cell's centre [cells].
    float normalX = 0.0f;   ///< Unit vector away from the wall; null where the point is the cell's centre.
    float normalY = 0.0f;   ///< Unit vector away from the wall; null where the point is the cell's centre.
    float unit = 0.0f;      ///< Unit cost, the same in all directions; 0 where directions differ.

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
    std::vector<CellCost> cells;  ///< One per cell, row-major.
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
