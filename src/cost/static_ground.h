// The static ground: obstacles and patches that stand still, prepared for many queries about paths.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cost/ground_level.h"
#include "environment/environment.h"

namespace muster {

struct GroundRasters;

/// Unit cost, clearance and lines of sight of the static ground for characters of one radius, with copies on
/// larger cells for longer paths.
class StaticGround {
public:
    /// Recomputes everything where the static ground, `openCost`, the unit cost of open ground, or the radius
    /// [m] has changed since the last call; otherwise does nothing.
    void update(const Environment& environment, double openCost, double radius);

    /// Grows by one with every change.
    std::uint32_t version() const { return version_; }
    const UnitCost& fine() const { return fine_.cost; }     ///< Unit cost on the ground cells.
    const GroundLevel& fineLevel() const { return fine_; }  ///< The level of the ground cells.
    const GroundLevel& middle() const { return middle_; }   ///< The level of cells twice as wide.
    /// Unit cost on cells 2, 4, 8... times as wide, of which there are at most kMaxCoarseCells. An edge holds
    /// the cheapest straight row of ground cells between the centres of two cells. It has no wall nodes: with
    /// them lines of sight would lead through cells that thin walls divide.
    const UnitCost& coarse() const { return coarse_; }
    /// A cell of coarse() whose centre is in a wall, and the neighbour from which its free side is reached.
    struct PartiallyBlockedCell {
        Cell cell;       ///< The cell.
        Cell neighbour;  ///< The neighbour.
        float cost;      ///< Cost from the neighbour to the cell.
    };
    /// All such cells. Cost fields on coarse() have no values for them, or only those of paths from the other
    /// side, though characters can stand there.
    std::span<const PartiallyBlockedCell> partiallyBlockedCells() const { return partiallyBlocked_; }
    /// True where the unit cost is the same everywhere.
    bool uniform() const { return uniform_; }
    /// True where in addition there is no obstacle.
    bool open() const { return open_; }
    /// Lower bound of the distance from `p` to the nearest wall or ground of another unit cost, for a
    /// character [m]; negative in walls.
    double uniformClearance(Vec2 p) const {
        const std::int32_t cell = cellAt(p);
        return cell >= 0 ? static_cast<double>(fine_.uniformClearance[cell]) - halfDiagonal_ : -1.0;
    }
    /// The same, interpolated between cells: more precise, but no bound.
    double interpolatedClearance(Vec2 p) const;
    /// Unit cost at `p`, walls ignored.
    float unitCost(Vec2 p) const {
        if (uniform_) return fine_.cost.lowest;
        const std::int32_t cell = cellAt(p);
        return unit_[cell >= 0 ? cell : grid_.index(grid_.nearestCell(p))];
    }
    /// True where the straight line from `a` to `b` is free and no other path is cheaper. May be false on
    /// slow ground where that is so.
    bool lineOfSight(Vec2 a, Vec2 b) const { return lineOfSight(a, b, distance(a, b)); }
    /// The same where the distance [m] is known.
    bool lineOfSight(Vec2 a, Vec2 b, double length) const;
    /// True where no wall is between `a` and `b`, whatever the unit cost.
    bool collisionFree(Vec2 a, Vec2 b) const {
        return open_ || traceSpheres(fine_.clearance, a, b, distance(a, b));
    }
    /// Cost of the straight line from `a` to `b`, walls ignored, from eight samples of the unit cost.
    double lineCost(Vec2 a, Vec2 b) const;

    static constexpr std::int32_t kMaxCoarseCells = 20000;  ///< Largest number of cells of coarse().

private:
    // Position in cells from the lower left corner of the ground.
    Vec2 inCells(Vec2 p) const { return (p - grid_.origin) * perCell_; }
    bool holds(Vec2 inCells) const {
        return inCells.x >= 0.0 && inCells.y >= 0.0 && inCells.x < grid_.width && inCells.y < grid_.height;
    }
    // Index of the cell that holds `p`, -1 outside.
    std::int32_t cellAt(Vec2 p) const {
        const Vec2 at = inCells(p);
        return holds(at) ? static_cast<std::int32_t>(at.y) * grid_.width + static_cast<std::int32_t>(at.x)
                         : -1;
    }
    bool traceSpheres(const std::vector<float>& clearance, Vec2 a, Vec2 b, double length) const;
    double interpolate(const std::vector<float>& clearance, Vec2 p) const;
    void computeLevel(GroundLevel& level, const GroundRasters& rasters);
    void computeMiddle(std::span<const float> clearance);
    void computeUniformClearance();
    void extendClearance();
    void limitByPatches();
    void computeCoarse();
    float coarseEdge(Cell from, Cell step, std::int32_t ratio) const;
    float edgeToBorder(Cell cell, Cell step, std::int32_t ratio) const;
    void findPartiallyBlocked(std::int32_t ratio);

    Grid grid_;
    double radius_ = -1.0;                      // [m]
    double openCost_ = -1.0;                    // Unit cost of open ground.
    std::uint64_t environmentVersion_ = ~0ull;  // The environment's version that this was computed from.
    std::uint32_t version_ = 0;
    bool open_ = true;
    bool uniform_ = true;
    double perCell_ = 1.0;       // Cells per metre [1/m].
    double halfDiagonal_ = 0.0;  // From the centre of a cell to its corner [m].
    GroundLevel fine_;
    GroundLevel middle_;
    UnitCost coarse_;
    std::vector<PartiallyBlockedCell> partiallyBlocked_;
    std::vector<float> speed_;  // Travel speed per ground cell, relative to running.
    std::vector<float> unit_;   // Unit cost per ground cell, in walls too.
    // Working memory.
    std::vector<float> scratch_;
    std::vector<float> middleClearance_;
    std::vector<float> middleSpeed_;
};

}  // namespace muster
