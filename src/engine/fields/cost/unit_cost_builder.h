// Builds the unit cost of the whole ground, for the exact plan (SPEC A3 to A5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_set.h"
#include "engine/fields/cost/density.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/ground/environment/environment.h"
#include "muster/generated/parameters.h"

namespace muster {

/// Builds unit costs. It keeps values that did not change since its last call as a cache: the result is the
/// same, bit for bit, as that of a new builder. The time of a call grows with the changes of crowd,
/// discomfort and ground, not with the size of the ground.
class UnitCostBuilder {
public:
    /// Brings cost() up to date for characters of `radius` [m] in this environment and crowd.
    void update(const Parameters& parameters, const Environment& environment, const DensityField& density,
                double radius);
    /// Updates and copies the unit cost to `cost`.
    void build(const Parameters& parameters, const Environment& environment, const DensityField& density,
               double radius, UnitCost& cost);

    /// The unit cost of the last call.
    const UnitCost& cost() const { return cost_; }
    /// The ground cost, without crowd and discomfort. Differs from cost() in dynamicCells() only.
    const std::vector<CellCost>& groundCost() const { return ground_; }
    /// The cells whose ground cost the last call computed again, ascending.
    std::span<const std::int32_t> groundChanges() const { return changes_; }
    /// The cells whose cost the crowd or discomfort changed in the last call, each once.
    std::span<const std::int32_t> dynamicCells() const { return dynamicCells_; }
    /// Discomfort g per ground cell of the last call.
    const std::vector<float>& discomfort() const { return discomfort_; }

private:
    /// A wall node whose unit cost was set to 0 because crowd or discomfort made the directions differ.
    struct ClearedNode {
        std::int32_t node = 0;  // Its index among the nodes.
        float unit = 0.0f;      // Its unit cost before.
    };

    void restoreGround();
    void updateGround(const Parameters::Cost& def, const Environment& environment, double radius);
    void computeAll(const Environment& environment);
    void findLowest();
    void findChanges(const Environment& environment);
    void compareRasters(const Environment& environment, const CellRect& area);
    void noteChange(Cell cell);
    void computeChanges();
    void mergeNodes();
    void updateDiscomfort(const Parameters::Discomfort& def, const Environment& environment);
    void addDynamicCost(const Parameters& parameters, const Environment& environment,
                        const DensityField& density);
    void findCrowd(const Parameters::Density& def, const DensityField& density);
    void updateGroundWithin(const Parameters& parameters, const Environment& environment,
                            const DensityField& density, std::int32_t densityCell);
    void updateCell(const Parameters& parameters, const DensityField& density, std::int32_t index,
                    double travelSpeed);

    UnitCost cost_;
    // The ground cost and the rasters it was computed from.
    std::vector<CellCost> ground_;
    std::vector<float> clearance_;    // Clearance of the ground cells [m].
    std::vector<float> travelSpeed_;  // Travel speed relative to running.
    std::vector<float> unit_;         // Cost of a true metre per cell; infinite in walls.
    std::int32_t lowestCount_ = 0;    // Number of cells with the lowest unit cost.
    double openCost_ = -1.0;          // Unit cost of open ground, alpha + beta.
    // Environment and its version that the rasters were read from.
    std::uint64_t instance_ = 0;
    std::uint64_t environmentVersion_ = 0;
    std::vector<CellRect> areas_;
    std::vector<std::int32_t> changes_;
    std::vector<std::uint8_t> changed_;  // Per cell: 1 while it is in changes_.
    std::vector<WallNode> newNodes_;
    std::vector<WallNode> mergedNodes_;
    // Cells in which the last call departed from the ground cost.
    std::vector<std::int32_t> dynamicCells_;
    std::vector<ClearedNode> clearedNodes_;
    std::vector<float> discomfort_;
    std::vector<std::int32_t> discomfortCells_;  // Ground cells with discomfort.
    CellSet crowdCells_;  // Density cells on whose ground the crowd can slow a character.
};

}  // namespace muster
