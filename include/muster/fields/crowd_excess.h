// What crowd and moving things add to the cost of the ground (SPEC A4, A5), for integrals along ways.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/environment/environment.h"
#include "muster/fields/density.h"
#include "muster/fields/unit_cost.h"

namespace muster {

/// The share by which a metre is dearer than on the empty ground, by direction, on the cells of the density. To first
/// order a small excess changes the cost of the cheapest way by its integral along the way that is cheapest without it.
class CrowdExcess {
public:
    /// Works it out for this crowd and these moving things, for characters of `radius` [m].
    void update(const UnitCostDef& def, const Environment& environment, const DensityField& density, double radius);
    /// The integral along the straight line from `a` to `b` [m]: to be multiplied by the cost of a metre of empty ground.
    double along(Vec2 a, Vec2 b) const;
    /// The cells.
    const Grid& grid() const { return grid_; }
    /// Relative excess of leaving a cell to the four sides; more than kBlocked nowhere.
    const std::vector<CellCost>& cells() const { return excess_; }
    /// True where there is none anywhere.
    bool none() const { return listed_.empty(); }

    static constexpr float kBlocked = 20.0f;  ///< Excess inside moving obstacles.

private:
    void clear();
    void addCrowd(const UnitCostDef& def, const DensityField& density, const Environment& environment);
    void addMoving(const UnitCostDef& def, const Environment& environment, double radius);
    void addMovedGround(const Environment& environment, double radius);
    void set(std::int32_t cell, const CellCost& value);
    void markBusy();

    Grid grid_;
    std::vector<CellCost> excess_;
    std::vector<std::uint8_t> busy_;      // Cells from which some excess can be read.
    std::vector<std::int32_t> listed_;    // Cells with excess, in the order they got it.
    std::vector<std::int32_t> busyList_;
    std::vector<std::uint8_t> looked_;    // Cells that were priced for the crowd.
    std::vector<std::int32_t> lookedList_;
    Box bounds_;                          // Of all busy cells.
};

}  // namespace muster
