// What a metre costs, by cell and direction (SPEC A3-A5, paper eq. 7).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cost/density.h"
#include "environment/environment.h"

namespace muster {

/// Weights and thresholds of the unit cost C = (alpha f + beta + gamma g) / (f TravelSpeed). The speed f is
/// relative to the free speed, so that alpha + beta = 1 makes C = 1 in the open: costs are then metres.
struct UnitCostDef {
    double alpha = 0.5;            ///< Weight of path length >= 0.
    double beta = 0.5;             ///< Weight of time >= 0; alpha + beta > 0.
    double gamma = 1.0;            ///< Weight of discomfort >= 0.
    bool density = true;           ///< Slows where it is crowded.
    bool discomfort = true;        ///< Avoids ground ahead of moving obstacles.
    double freeSpeed = 2.0;        ///< Speed of a character in the open [m/s] > 0.
    double densityMin = 1.3;       ///< Below it nobody is slowed [1/m^2].
    double densityMax = 3.5;       ///< Above it one moves with the flow [1/m^2] > densityMin.
    double lookAhead = 0.5;        ///< Distance r at which density is read [m] >= 0.
    double minSpeed = 0.05;        ///< Floor of f, relative to the free speed > 0.
    double discomfortTime = 1.5;   ///< How far ahead moving obstacles are predicted [s] >= 0.
    double discomfortRange = 1.0;  ///< Discomfort reaches this far beyond the swept surface [m] > 0.
    double discomfortGain = 8.0;  ///< Value of g on the obstacle's own track; falls to 0 with time and range.
};

/// Cost per metre of leaving a cell in the four directions; infinite for walls and into walls.
struct CellCost {
    float east = 1.0f;
    float north = 1.0f;
    float west = 1.0f;
    float south = 1.0f;

    /// Lets an archive read or write the cost.
    template <class Archive>
    void visit(Archive& archive) {
        archive(east, north, west, south);
    }
};

/// A cell beside a wall. The value of a field there is that of the nearest point to which a character can
/// come, as far as that is less than a cell away, so that ways along walls and round corners have their true
/// length.
struct WallNode {
    std::int32_t cell = 0;  ///< Its index.
    float x = 0.0f;         ///< That point, from the cell's centre [cells].
    float y = 0.0f;         ///< That point, from the cell's centre [cells].
    float normalX = 0.0f;   ///< Unit vector away from the wall; null where the point is the centre.
    float normalY = 0.0f;   ///< Unit vector away from the wall; null where the point is the centre.
    float unit = 0.0f;      ///< Cost of a metre in all directions; 0 where directions differ.

    /// Lets an archive read or write the node.
    template <class Archive>
    void visit(Archive& archive) {
        archive(cell, x, y, normalX, normalY, unit);
    }
};

/// The unit cost of one radius class over the whole ground.
struct UnitCost {
    Grid grid;                    ///< The ground cells.
    double radius = 0.25;         ///< Cells whose centre is nearer to an obstacle are walls [m].
    std::vector<CellCost> cells;  ///< Row-major.
    std::vector<WallNode> nodes;  ///< Ascending by cell.
    /// Of a metre anywhere; edges of cells drawn to walls may bear less, being shorter.
    float lowest = 1.0f;

    /// True where nobody of this radius can be.
    bool wall(std::int32_t index) const {
        const CellCost& c = cells[index];
        constexpr float kInfinite = 3.0e38f;
        return c.east > kInfinite && c.north > kInfinite && c.west > kInfinite && c.south > kInfinite;
    }
    /// Lets an archive read or write the cost.
    template <class Archive>
    void visit(Archive& archive) {
        archive(grid, radius, cells, nodes, lowest);
    }
};

/// Builds unit costs; keeps what did not change since its last call as a cache (the result is the same
/// as that of a new builder). A call costs about what crowd, discomfort and ground changed, not the size of
/// the ground.
class UnitCostBuilder {
public:
    /// Brings cost() up to date for characters of `radius` [m] in this environment and crowd.
    void update(const UnitCostDef& def, const Environment& environment, const DensityField& density,
                double radius);
    /// The same, copied to `cost`.
    void build(const UnitCostDef& def, const Environment& environment, const DensityField& density,
               double radius, UnitCost& cost);

    /// The unit cost of the last call.
    const UnitCost& cost() const { return cost_; }
    /// The same without crowd and discomfort; differs only in the cells priced().
    const std::vector<CellCost>& ground() const { return ground_; }
    /// Grows whenever ground() changes.
    std::uint64_t groundVersion() const { return groundVersion_; }
    /// The cells of ground() that the last call priced anew, ascending; empty where it kept all of them.
    std::span<const std::int32_t> groundChanges() const { return changes_; }
    /// Cells that crowd or discomfort priced in the last call, each once.
    std::span<const std::int32_t> priced() const { return priced_; }
    /// Discomfort g per ground cell of the last call.
    const std::vector<float>& discomfort() const { return discomfort_; }

private:
    struct HiddenNode {
        std::int32_t node = 0;  // Its number among the nodes.
        float unit = 0.0f;
    };

    void restoreGround();
    void updateGround(const UnitCostDef& def, const Environment& environment, double radius);
    void priceAll(const Environment& environment);
    void findLowest();
    void findChanges(const Environment& environment);
    void compareRasters(const Environment& environment, const CellRect& area);
    void priceChanges();
    void mergeNodes();
    void updateDiscomfort(const UnitCostDef& def, const Environment& environment);
    void priceCrowd(const UnitCostDef& def, const Environment& environment, const DensityField& density);
    void markCrowded(const UnitCostDef& def, const DensityField& density);
    void priceCell(const UnitCostDef& def, const DensityField& density, std::int32_t index,
                   double travelSpeed);

    UnitCost cost_;
    // The empty ground, with what it was made of.
    std::vector<CellCost> ground_;
    std::vector<float> clearance_;
    std::vector<float> travelSpeed_;
    std::vector<float> unit_;       // Of a metre; infinite in walls.
    std::int32_t lowestCount_ = 0;  // Cells whose metre costs the least.
    double price_ = -1.0;
    std::uint64_t groundVersion_ = 0;
    std::uint64_t instance_ = 0;  // Environment and version that the rasters were read from.
    std::uint64_t environmentVersion_ = 0;
    std::vector<CellRect> areas_;
    std::vector<std::int32_t> changes_;
    std::vector<std::uint8_t> changed_;  // Of each cell, 1 while changes_ is collected.
    std::vector<WallNode> freshNodes_;
    std::vector<WallNode> mergedNodes_;
    // Cells that the last call priced apart from the empty ground.
    std::vector<std::int32_t> priced_;
    std::vector<HiddenNode> hiddenNodes_;  // Nodes whose unit that took away.
    std::vector<float> discomfort_;
    std::vector<std::int32_t> uneasy_;        // Ground cells with discomfort.
    std::vector<std::uint8_t> crowded_;       // Density cells that can slow somebody, 1 each.
    std::vector<std::int32_t> crowdedCells_;  // The same, listed.
};

}  // namespace muster
