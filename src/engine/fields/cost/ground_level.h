// The static ground on cells of one size.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fields/cost/ground_cost.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/cost/unit_cost.h"

namespace muster {

/// One level of a grid hierarchy over the static ground, which must outlive it: ground cells, or cells twice
/// as wide. It holds no rasters: all is derived from the clearance of the ground cells.
class GroundLevel {
public:
    /// `ratio` is 1 for ground cells, 2 for cells twice as wide.
    GroundLevel(const StaticGround& ground, std::int32_t ratio);

    const Grid& grid() const { return grid_; }  ///< The cells of this level.
    /// Distance from a cell's centre to the nearest obstacle less the characters' radius [m]; negative in
    /// walls. A wider cell's centre is the corner where four ground cells meet: it takes their mean.
    float clearance(std::int32_t cell) const;
    /// Lower bound of the distance from a cell's centre to the nearest wall or ground of another unit cost,
    /// less the radius for walls [m].
    float uniformClearance(std::int32_t cell) const;
    /// True where no character of this radius can stand at the centre of the cell.
    bool blocked(std::int32_t cell) const { return clearance(cell) < 0.0f; }
    /// The free cell whose centre is nearest to `p` within two cells; -1 where there is none.
    std::int32_t freeCellNear(Vec2 p) const;
    /// Lower bound of the unit cost.
    float lowestUnitCost() const { return ground_->lowestUnitCost(); }

    /// Working memory of unitCost().
    struct Scratch {
        std::vector<float> clearance;
        std::vector<float> speed;
        std::vector<ClosedGap> gaps;
        std::vector<NarrowCell> narrow;
        GroundCostCrop crop;
    };
    /// Computes the unit cost of the cells in `area`; cells off the ground are walls.
    void unitCost(const CellRect& area, Scratch& scratch, UnitCost& cost) const;
    /// Computes the unit cost of all cells.
    UnitCost unitCost() const;
    /// True where all ground has one unit cost.
    bool uniform() const { return ground_->uniform(); }
    /// The version of the ground.
    std::uint32_t version() const { return ground_->version(); }
    /// Appends to `areas` the cells of this level whose unit cost may have changed since the version was
    /// `version`; false where all cells may have. Some areas reach beyond the ground.
    bool changesSince(std::uint32_t version, std::vector<CellRect>& areas) const;

private:
    float meanClearance(Cell cell) const;
    void findNarrow(const CellRect& cells, const Grid& crop, std::vector<NarrowCell>& narrow) const;
    float meanSpeed(Cell cell) const;

    const StaticGround* ground_;
    std::int32_t ratio_;
    Grid grid_;
};

inline GroundLevel StaticGround::fineLevel() const {
    return {*this, 1};
}
inline GroundLevel StaticGround::middle() const {
    return {*this, 2};
}

}  // namespace muster
