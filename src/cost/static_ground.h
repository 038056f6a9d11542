// The ground without crowd and moving things, prepared for many questions about ways.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cost/ground_level.h"
#include "environment/environment.h"

namespace muster {

struct GroundRasters;

/// What stands still, for characters of one radius: unit cost, room to all sides, and coarser copies for
/// longer ways.
class StaticGround {
public:
    /// Makes everything anew where what stands still, the radius [m] or `price`, the cost of a metre in the
    /// open, has changed since the last call; else does nothing.
    void update(const Environment& environment, double price, double radius);

    /// Grows by one with every change.
    std::uint32_t version() const { return version_; }
    const UnitCost& fine() const { return fine_.cost; }     ///< On the ground cells.
    const GroundLevel& fineLevel() const { return fine_; }  ///< The same with the room to walls.
    const GroundLevel& middle() const { return middle_; }   ///< On cells twice as wide.
    /// On cells 2, 4, 8... times as wide, at most kCoarseCells.
    const UnitCost& coarse() const { return coarse_; }
    /// A cell of coarse() whose middle nobody can stand on, and the neighbour from which its near side is
    /// reached.
    struct PartiallyBlockedCell {
        Cell cell;
        Cell neighbour;
        float cost;  ///< Of going across.
    };
    /// All such cells: fields on coarse() do not know them, or only by a way round, though people stand
    /// there.
    std::span<const PartiallyBlockedCell> partiallyBlockedCells() const { return partiallyBlocked_; }
    /// True where all ground costs the same.
    bool uniform() const { return uniform_; }
    /// True where all ground costs the same and nothing stands in the way.
    bool open() const { return open_; }
    /// How far round `p` the ground is uniform and free for a character, a lower bound; below 0 in walls [m].
    double uniformClearance(Vec2 p) const {
        const std::int32_t cell = cellAt(p);
        return cell >= 0 ? static_cast<double>(fine_.uniformClearance[cell]) - slack_ : -1.0;
    }
    /// The same, interpolated between cells: closer, though no bound.
    double interpolatedClearance(Vec2 p) const;
    /// Cost of a metre at `p`.
    float unitCost(Vec2 p) const {
        if (uniform_) return fine_.cost.lowest;
        const std::int32_t cell = cellAt(p);
        return unit_[cell >= 0 ? cell : grid_.index(grid_.nearestCell(p))];
    }
    /// True where a character can go straight from `a` to `b` and does best to. On slow ground it may say
    /// no though that is so.
    bool lineOfSight(Vec2 a, Vec2 b) const { return lineOfSight(a, b, distance(a, b)); }
    /// The same where the distance is known.
    bool lineOfSight(Vec2 a, Vec2 b, double whole) const;
    /// True where no wall is between `a` and `b`, whatever the ground costs.
    bool collisionFree(Vec2 a, Vec2 b) const {
        return open_ || reaches(fine_.clearance, a, b, distance(a, b));
    }
    /// Cost of the straight line, walls or none, by a few samples of the ground.
    double lineCost(Vec2 a, Vec2 b) const;

    static constexpr std::int32_t kCoarseCells = 20000;  ///< Most cells of the coarse copy.

private:
    // In cells from the corner of the ground.
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
    bool reaches(const std::vector<float>& room, Vec2 a, Vec2 b, double whole) const;
    double between(const std::vector<float>& room, Vec2 p) const;
    void makeRoom(const Environment& environment);
    void widenRoom();
    void narrowByPatches();
    void makeLevel(GroundLevel& level, const GroundRasters& rasters);
    void makeMiddle(std::span<const float> clearance);
    void makeCoarse();
    float coarseEdge(Cell from, Cell step, std::int32_t ratio) const;
    float nearSide(Cell cell, Cell step, std::int32_t ratio) const;
    void findBeside(std::int32_t ratio);

    Grid grid_;
    double radius_ = -1.0;
    double price_ = -1.0;
    std::uint64_t seen_ = ~0ull;  // The environment's version.
    std::uint32_t version_ = 0;
    bool open_ = true;
    bool uniform_ = true;   // No patches.
    double perCell_ = 1.0;  // [1/m]
    double slack_ = 0.0;    // From the centre of a cell to its corner [m].
    GroundLevel fine_;
    GroundLevel middle_;
    UnitCost coarse_;
    std::vector<PartiallyBlockedCell> partiallyBlocked_;
    std::vector<float> speed_;
    std::vector<float> unit_;
    std::vector<float> far_;  // Working memory.
    std::vector<float> middleClearance_;
    std::vector<float> middleSpeed_;
};

}  // namespace muster
