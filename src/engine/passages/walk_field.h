// Costs of walks between a passage, or a point, and all other points, on the coarse ground.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bilinear.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/passages/passage.h"

namespace muster {

/// The walk from one point.
struct Walk {
    double cost = 0.0;      ///< Cost of the walk [m of open ground]; infinite where there is none.
    std::int32_t side = 0;  ///< Side of the passage on which it ends: 1 left, -1 right, 0 neither.
};

/// A point, located among the cells, for all fields on one ground.
struct WalkSpot {
    Vec2 point;
    BilinearStencil stencil;
    std::int32_t nearest = 0;  ///< Nearest cell.
};

/// The cost of the cheapest walk from every cell to a passage that nobody goes through, from either side.
class WalkField {
public:
    /// Locates a point.
    WalkSpot spot(Vec2 p) const { return {p, bilinearStencil(grid_, p), grid_.index(grid_.nearestCell(p))}; }
    /// The walk from a spot on the same ground. Near the passage the side is exact.
    Walk atSpot(const WalkSpot& spot) const;
    /// The walk from a point.
    Walk at(Vec2 p) const { return atSpot(spot(p)); }
    /// The walk from the centre of a cell, which is unreached where it is in a wall.
    Walk ofCell(std::int32_t cell) const {
        const auto cost = static_cast<double>(cost_[cell]);
        return {cost, side_[cell]};
    }
    /// The first `most` cells of the cheapest walk from `p` to the source, as points [m]; empty where there
    /// is none.
    void trace(Vec2 p, std::size_t most, std::vector<Vec2>& path) const;

private:
    friend class WalkSolver;
    bool isCutOff(std::int32_t cell) const;
    std::int32_t reachedCell(Vec2 p) const;
    std::int32_t nextCell(std::int32_t cell) const;

    Grid grid_;
    Passage passage_;                 // The passage; with two equal ends for a point.
    Box near_;                        // Box of the points near the passage.
    std::vector<float> cost_;         // Per cell.
    std::vector<std::int8_t> side_;   // Per cell.
    std::vector<std::uint8_t> open_;  // Per cell: bits of its open edges, east, north, west, south.
};

/// The open edges between cells.
class WalkEdges {
public:
    /// Opens all edges of this ground.
    void open(const UnitCost& ground);
    /// Shuts the edges that cross the passage.
    void close(const Passage& passage);
    /// The open edges of a cell as bits: 1 east, 2 north, 4 west, 8 south.
    std::uint8_t ofCell(std::int32_t cell) const { return open_[cell]; }
    const Grid& grid() const { return grid_; }  ///< The cells.

private:
    friend class WalkSolver;

    Grid grid_;
    std::vector<std::uint8_t> open_;  // Per cell, as in WalkField.
};

/// Solves one walk field at a time by fast marching (Sethian 1996) of first order, in any number of pieces.
/// After a number of cells a field depends on nothing else, so that a march can be repeated up to where it
/// was. Owns the working memory.
class WalkSolver {
public:
    /// Begins from both sides of a passage, whose edges must be closed.
    void begin(const UnitCost& ground, const WalkEdges& edges, const Passage& passage, WalkField& field);
    /// Begins from a point.
    void begin(const UnitCost& ground, const WalkEdges& edges, Vec2 source, WalkField& field);
    /// Lets the march end when WalkField::at() holds for this point, and for all others given after begin().
    void stopAt(Vec2 p, const WalkField& field);
    /// Lets the march end at this cost. Costlier walks are then unknown or too costly.
    void stopBeyond(double cost) { most_ = static_cast<float>(cost); }
    /// Solves up to `cells` cells and subtracts the number from `cells`. True once the march has ended. The
    /// ground and the field must be those of begin().
    bool advance(const UnitCost& ground, WalkField& field, std::int64_t& cells);

private:
    void reset(const WalkEdges& edges, WalkField& field);
    void seed(WalkField& field, std::int32_t cell, double cost, std::int32_t side);
    void seedPassage(const UnitCost& ground, WalkField& field);
    void spread(const UnitCost& ground, WalkField& field, std::int32_t cell);
    bool want(std::int32_t cell, const WalkField& field);
    void push(float cost, std::int32_t cell);

    std::vector<std::uint64_t> heap_;  // The front: cost, then cell; the least first.
    std::vector<std::uint8_t> mark_;   // Per cell: bit 0 solved, bit 1 wanted by stopAt().
    // Number of wanted cells that are not solved yet; -1 where all cells are wanted.
    std::int32_t wanted_ = -1;
    float most_ = 0.0f;
};

}  // namespace muster
