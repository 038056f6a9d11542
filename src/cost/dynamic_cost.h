// What crowd and moving things add to the cost of the ground (SPEC A4, A5), for integrals along ways.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bilinear.h"
#include "cost/density.h"
#include "cost/static_ground.h"
#include "cost/unit_cost.h"
#include "environment/environment.h"

namespace muster {

/// The share by which a metre is dearer than on the empty ground: for the crowd by direction, on the cells of
/// the density; for what moves in all directions alike, its discomfort and its patches on finer cells, its
/// bodies on those of the ground. To first order a small excess changes the cost of the cheapest way by its
/// integral along the way that is cheapest without it.
class DynamicCost {
public:
    /// Makes room for the cells of this ground and this density; no excess anywhere then.
    void reset(const Grid& ground, const Grid& density);
    /// Works it out for this crowd and these moving things, for characters of `radius` [m].
    void update(const UnitCostDef& def, const Environment& environment, const DensityField& density,
                double radius);
    /// The integral along the straight line from `a` to `b` [m]: to be multiplied by the cost of a metre of
    /// empty ground.
    double relativeAlong(Vec2 a, Vec2 b) const { return relativeAlong(a, b, distance(a, b)); }
    /// The same where the length of the line is known.
    double relativeAlong(Vec2 a, Vec2 b, double length) const;
    /// The integral times the cost of a metre of the still ground under it, which may change on the way.
    double costAlong(const StaticGround& ground, Vec2 a, Vec2 b) const {
        return costAlong(ground, a, b, distance(a, b));
    }
    /// The same where the length of the line is known.
    double costAlong(const StaticGround& ground, Vec2 a, Vec2 b, double length) const;
    /// The share of the line from `a` to `b`, of this length, at which moving things make it dearest, in the
    /// mean; negative where none does.
    double movingCostCentroid(Vec2 a, Vec2 b, double length) const;
    /// The excess of moving things at a point.
    double movingCostAt(Vec2 p) const { return hazardMeets(p, p) ? hazardRead(p) : 0.0; }
    /// True where moving things make the ground dearer or cheaper.
    bool hasMovingCost(Vec2 p) const { return movingCostAt(p) != 0.0; }
    /// The cells.
    const Grid& grid() const { return grid_; }
    /// True where there is none anywhere.
    bool empty() const { return listed_.empty() && moved_.empty() && takenList_.empty(); }

    /// Excess inside moving obstacles, and the most of them elsewhere.
    static constexpr float kBlocked = 20.0f;
    static constexpr double kMovingCell = 0.25;  ///< Edge of the finer cells [m].

private:
    /// The sides towards which a unit vector leads.
    struct Sides;
    /// A box round cells from which something can be read; empty at first.
    struct Bounds {
        Vec2 min{1e300, 1e300};
        Vec2 max{-1e300, -1e300};
        /// Grows it round a cell.
        void take(Vec2 centre, double cell) {
            min = {centre.x - cell < min.x ? centre.x - cell : min.x,
                   centre.y - cell < min.y ? centre.y - cell : min.y};
            max = {centre.x + cell > max.x ? centre.x + cell : max.x,
                   centre.y + cell > max.y ? centre.y + cell : max.y};
        }
        /// True where the box round the line meets it.
        bool meets(Vec2 a, Vec2 b) const {
            return (a.x > min.x || b.x > min.x) && (a.x < max.x || b.x < max.x) &&
                   (a.y > min.y || b.y > min.y) && (a.y < max.y || b.y < max.y);
        }
    };
    void clear();
    void addCrowd(const UnitCostDef& def, const DensityField& density, const Environment& environment);
    void addDiscomfortOf(const UnitCostDef& def, const ObstaclePiece& piece);
    void addMovedGround(const Environment& environment, double radius);
    void addMovedPatches(const Environment& environment, const CellRect& area);
    void setHazard(std::int32_t cell, float value);
    void set(std::int32_t cell, const CellCost& value);
    void markBusy();
    void sumBusy();
    bool busyAlong(Vec2 a, Vec2 b) const;
    // The speed, relative to the free one of the ground, at which a metre has this excess.
    float speedAt(float excess) const { return perSecond_ / (1.0f + excess - perMetre_); }
    double crowdAlong(Vec2 p, const Sides& sides) const;
    double crowdAlong(Vec2 p, const Sides& sides, float unit) const;
    double hazardRead(Vec2 p) const;
    bool hazardMeets(Vec2 a, Vec2 b) const {
        return !(moved_.empty() && takenList_.empty()) && hazardBounds_.meets(a, b);
    }

    Grid grid_;
    BilinearLocator locator_;       // Of its cells.
    float perMetre_ = 0.0f;         // Parts of the cost of a metre of empty ground: of the way...
    float perSecond_ = 1.0f;        // ... and of the time.
    std::vector<CellCost> excess_;  // Relative, of leaving a cell to the four sides.
    // Cost of a metre of ground in the middle of cells that were priced for the crowd.
    std::vector<float> unit_;
    std::vector<std::uint8_t> busy_;    // Cells from which some excess can be read.
    std::vector<std::int32_t> listed_;  // Cells with excess, in the order they got it.
    std::vector<std::int32_t> busyList_;
    Cell busyLow_;  // The box round all of them...
    Cell busyHigh_;
    std::int32_t busyStride_ = 0;
    std::vector<std::int32_t> busySum_;  // ... and how many lie below and left of each cell of it.
    std::vector<std::uint8_t> looked_;   // Cells that were priced for the crowd.
    std::vector<std::int32_t> lookedList_;
    Bounds crowdBounds_;
    Bounds hazardBounds_;  // Of all that moves...
    Bounds takenBounds_;   // ... and of what is taken.
    Grid hazardGrid_;
    BilinearLocator movingLocator_;
    std::vector<float> hazard_;
    std::vector<std::int32_t> moved_;  // Cells of it that moving things make dearer or cheaper.
    std::vector<std::uint8_t> seen_;   // Of those under moving things.
    std::vector<std::int32_t> seenList_;
    Grid ground_;
    std::vector<std::uint8_t> taken_;  // Ground cells where a moving obstacle leaves nobody room.
    std::vector<std::int32_t> takenList_;
};

}  // namespace muster
