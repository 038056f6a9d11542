// The static ground: static obstacles and patches, prepared for many queries about paths.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/fields/cost/distant_clearance.h"
#include "engine/fields/cost/gap_index.h"
#include "engine/fields/cost/narrow_ways.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/ground/environment/environment.h"

namespace muster {

class GroundLevel;

/// Clearance, unit cost and lines of sight of the static ground for characters of one radius. It reads the
/// environment's own raster of the clearance, which must outlive it, and derives every answer from it;
/// further rasters exist only where there are patches.
class StaticGround {
public:
    /// Brings everything up to date where the static ground, `openCost`, the unit cost of open ground, or the
    /// radius [m] has changed since the last call. After edits of obstacles the cost depends on their size,
    /// not on that of the ground. Between an edit and this call nothing else may be called.
    void update(const Environment& environment, double openCost, double radius);

    /// Version of the ground; grows by one with every change.
    std::uint32_t version() const { return version_; }
    /// Appends to `areas` the ground cells that have changed since version() was `version`; false where all
    /// cells may have.
    bool changesSince(std::uint32_t version, std::vector<CellRect>& areas) const;
    const Grid& grid() const { return grid_; }     ///< The ground cells.
    double radius() const { return radius_; }      ///< Radius of the characters [m].
    double openCost() const { return openCost_; }  ///< Unit cost of open ground.
    /// Lower bound of the unit cost.
    float lowestUnitCost() const { return lowest_; }
    GroundLevel fineLevel() const;  ///< The level of the ground cells (ground_level.h).
    GroundLevel middle() const;     ///< The level of cells twice as wide (ground_level.h).
    /// Unit cost on cells 2, 4, 8... times as wide, at most kMaxCoarseCell: wider ones would show neither
    /// doors nor streets. An edge holds the cheapest straight row of ground cells between the centres of two
    /// cells. It has no wall nodes: with them lines of sight would lead through cells that thin walls divide.
    /// Without values where ground cells are too wide.
    const UnitCost& coarse() const { return coarse_; }
    /// True where coarse() is there and so small, at most kMaxCoarseCells, that fields may cover all of it.
    bool hasCoarse() const {
        return !coarse_.cells.empty() && std::cmp_less_equal(coarse_.cells.size(), kMaxCoarseCells);
    }
    /// True where coarse() is there, but too large for fields over all of it.
    bool hasWideCoarse() const { return std::cmp_greater(coarse_.cells.size(), kMaxCoarseCells); }
    /// A cell of coarse() whose centre is in a wall, and the neighbour from which its free side is reached.
    struct PartiallyBlockedCell {
        Cell cell;       ///< The cell.
        Cell neighbour;  ///< The neighbour.
        float cost;      ///< Cost from the neighbour to the cell.
    };
    /// All such cells. Cost fields on coarse() have no values for them, or only values of paths from the
    /// other side, though characters can stand there.
    std::span<const PartiallyBlockedCell> partiallyBlockedCells() const { return partiallyBlocked_; }
    /// Partially blocked cells in the rows from `first` to `last` of coarse().
    std::span<const PartiallyBlockedCell> partiallyBlockedCellsIn(std::int32_t first,
                                                                  std::int32_t last) const;
    /// True where the unit cost is the same everywhere.
    bool uniform() const { return unit_.empty(); }
    /// True where in addition there is no obstacle.
    bool open() const { return open_; }
    /// Distance from each cell's centre to the nearest obstacle, up to the environment's limit [m].
    std::span<const float> rawClearance() const { return clearance_; }
    /// Distance from a cell's centre to the nearest obstacle less the radius [m]; negative in walls.
    float clearance(std::int32_t cell) const { return clearance_[cell] - floatRadius_; }
    /// True where no character can stand at the centre of a cell.
    bool blocked(std::int32_t cell) const { return clearance(cell) < 0.0f; }
    /// Lower bound of the distance from the centre of a cell to the nearest wall or ground of another unit
    /// cost, less the radius for walls [m]; beyond the environment's limit too.
    float uniformClearanceOf(Cell c) const { return uniformClearanceOf(c, grid_.index(c)); }
    /// Lower bound of the uniform clearance where the index of the cell is known.
    float uniformClearanceOf(Cell c, std::int32_t cell) const {
        const float walls = extendedClearance(c, cell);
        return uniform() || walls < toOtherGround_[cell] ? walls : toOtherGround_[cell];
    }
    /// Lower bound of the distance from `p` to the nearest wall or ground of another unit cost, for a
    /// character [m]; negative in walls.
    double uniformClearance(Vec2 p) const {
        const Vec2 at = inCells(p);
        return holds(at) ? static_cast<double>(uniformClearanceOf(cellAt(at))) - halfDiagonal_ : -1.0;
    }
    /// The uniform clearance interpolated between cells: more precise, but no bound.
    double interpolatedClearance(Vec2 p) const;
    /// Unit cost at `p`, walls ignored.
    float unitCost(Vec2 p) const {
        if (uniform()) return lowest_;
        const Vec2 at = inCells(p);
        return unit_[grid_.index(holds(at) ? cellAt(at) : grid_.nearestCell(p))];
    }
    /// Unit cost of a cell, walls ignored.
    float unitCostOf(std::int32_t cell) const { return uniform() ? lowest_ : unit_[cell]; }
    /// Travel speed of a cell relative to running.
    float travelSpeed(std::int32_t cell) const {
        return patchSpeed_[cell] < kUnreachableCost ? patchSpeed_[cell] : 1.0f;
    }
    /// The gaps that are too narrow for the characters.
    const GapIndex& gaps() const { return gaps_; }
    /// The cells of ways too narrow for the raster to show.
    const NarrowWays& narrowWays() const { return narrow_; }
    /// True where the straight line from `a` to `b` is free, but for rounding, and no other path is cheaper.
    /// May be false for such a line on slow ground. Never true through a gap that is too narrow.
    bool lineOfSight(Vec2 a, Vec2 b) const { return lineOfSight(a, b, distance(a, b)); }
    /// Tests the line of sight where the distance [m] is known.
    bool lineOfSight(Vec2 a, Vec2 b, double length) const;
    /// True where no wall is between `a` and `b`, whatever the unit cost.
    bool collisionFree(Vec2 a, Vec2 b) const;
    /// Cost of the straight line from `a` to `b`, walls ignored, from eight samples of the unit cost.
    double lineCost(Vec2 a, Vec2 b) const;

    static constexpr std::int32_t kMaxCoarseCells = 20000;  ///< Most cells that one field covers.
    static constexpr double kMaxCoarseCell = 1.0;           ///< Largest edge of a cell of coarse() [m].

private:
    // Position in cells from the lower left corner of the ground.
    Vec2 inCells(Vec2 p) const { return (p - grid_.origin) * perCell_; }
    bool holds(Vec2 inCells) const {
        return inCells.x >= 0.0 && inCells.y >= 0.0 && inCells.x < grid_.width && inCells.y < grid_.height;
    }
    static Cell cellAt(Vec2 inCells) {
        return {static_cast<std::int32_t>(inCells.x), static_cast<std::int32_t>(inCells.y)};
    }
    // Clearance less the radius, continued beyond the environment's limit.
    float extendedClearance(Cell c, std::int32_t cell) const {
        const float raw = clearance_[cell] - floatRadius_;
        return raw < capped_ ? raw : raw + distant_.beyond(c);
    }
    template <class Clearance>
    bool traceSpheres(Vec2 a, Vec2 b, double length, const Clearance& clearance) const;
    struct Squares;
    template <class Clearance>
    double interpolate(const Squares& squares, Vec2 inCells, const Clearance& clearance) const;
    bool findChanges(const Environment& environment, double openCost, double radius);
    void noteChanges(bool all);
    void updatePatches();
    void resetCoarse();
    void updateCoarse(const CellRect& area);
    void updateCoarseEdges(const CellRect& cells, std::int32_t ratio);
    // Tests a segment of at most a metre for a closed gap.
    bool crossesGap(Vec2 a, Vec2 b) const { return !gaps_.empty() && gaps_.crossed(a, b, 0.5 * (a + b)); }
    int coarseState(Cell middle, std::int32_t ratio) const;
    float coarseEdge(Cell from, Cell step, std::int32_t ratio) const;
    float edgeToBorder(Cell cell, Cell step, std::int32_t ratio) const;
    void findPartiallyBlocked(const CellRect& cells, std::int32_t ratio);

    Grid grid_;
    double radius_ = -1.0;       // Radius of the characters [m].
    float floatRadius_ = -1.0f;  // Radius of the characters [m].
    double openCost_ = -1.0;     // Unit cost of open ground.
    // The environment's instance and versions that this was computed from.
    std::uint64_t instance_ = 0;
    std::uint64_t environmentVersion_ = ~0ull;
    std::uint64_t patchVersion_ = ~0ull;
    std::uint32_t version_ = 0;
    bool open_ = true;
    double perCell_ = 1.0;              // Cells per metre [1/m].
    double halfDiagonal_ = 0.0;         // Distance from the centre of a cell to its corner [m].
    float capped_ = 0.0f;               // Clearance from which on values are at the environment's limit [m].
    float lowest_ = 1.0f;               // Lowest unit cost.
    std::span<const float> clearance_;  // The clearance of the environment.
    RasterView patchSpeed_{nullptr};    // The speeds of the environment's patches.
    DistantClearance distant_;
    GapIndex gaps_;
    NarrowWays narrow_;
    // Per ground cell, empty where the unit cost is the same everywhere:
    std::vector<float> unit_;           // Unit cost, in walls too.
    std::vector<float> toOtherGround_;  // Lower bound of the distance to ground of another unit cost [m].
    UnitCost coarse_;
    // Partially blocked cells, in the order of their cells.
    std::vector<PartiallyBlockedCell> partiallyBlocked_;
    /// Ground cells that changed with a version.
    struct Change {
        std::uint32_t version = 0;
        CellRect area;
    };
    std::vector<Change> changes_;
    std::uint32_t changesFrom_ = 0;  // The version from which `changes_` lead to the present one.
    std::vector<CellRect> areas_;    // Changed areas of the present update.
};

}  // namespace muster
