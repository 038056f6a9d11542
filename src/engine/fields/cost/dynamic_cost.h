// Dynamic cost: the part of the unit cost that crowd and moving obstacles add to the static ground (SPEC A4,
// A5; Treuille, Cooper and Popovic 2006, section 4.1), for line integrals along paths.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bilinear.h"
#include "base/cell_set.h"
#include "base/grid.h"
#include "base/sparse_raster.h"
#include "base/summed_area_table.h"
#include "engine/fields/cost/density.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/environment/obstacle_piece.h"
#include "muster/generated/parameters.h"

namespace muster {

/// The increase of the unit cost relative to that of the static ground. It has two layers: the crowd cost, by
/// direction, on the cells of the density; and the moving cost of obstacles and patches that move, equal in
/// all directions, on cells of kMovingCell (on ground cells under the obstacles themselves). To first order a
/// small increase raises the cost of a cheapest path by its integral along the path that is cheapest without
/// it.
class DynamicCost {
public:
    /// Allocates for these ground cells and density cells and sets the cost to zero everywhere.
    void reset(const Grid& ground, const Grid& density);
    /// Computes the cost of this crowd and these moving things for characters of `radius` [m].
    void update(const Parameters& parameters, const Environment& environment, const DensityField& density,
                double radius);
    /// Integral of the relative cost along the straight line from `a` to `b` [m]. Multiplied by a uniform
    /// unit cost of the static ground it is a cost.
    double relativeAlong(Vec2 a, Vec2 b) const { return relativeAlong(a, b, distance(a, b)); }
    /// Integral of the relative cost where the length of the line [m] is known.
    double relativeAlong(Vec2 a, Vec2 b, double length) const;
    /// Integral of the dynamic cost along the straight line from `a` to `b`, over static ground whose unit
    /// cost may vary.
    double costAlong(const StaticGround& ground, Vec2 a, Vec2 b) const {
        return costAlong(ground, a, b, distance(a, b));
    }
    /// Integral of the dynamic cost where the length of the line [m] is known.
    double costAlong(const StaticGround& ground, Vec2 a, Vec2 b, double length) const {
        return costAndCentroid(ground, a, b, length).cost;
    }
    /// A cost along a line, and where on the line things move.
    struct LineCost {
        double cost;      ///< The cost by costAlong() [m].
        double centroid;  ///< The centroid by movingCostCentroid().
    };
    /// Cost and centroid at once.
    LineCost costAndCentroid(const StaticGround& ground, Vec2 a, Vec2 b, double length) const;
    /// Centroid of the moving cost along the line from `a` to `b` of this length [m], as a fraction of the
    /// line; negative where there is none.
    double movingCostCentroid(Vec2 a, Vec2 b, double length) const;
    /// Relative moving cost at a point.
    double movingCostAt(Vec2 p) const {
        if (movingCells_.empty() && blockedCells_.empty()) return 0.0;
        if (blockedBounds_.meets(p, p) && blocked_[ground_.nearestCell(p)] != 0) return kBlocked;
        const BilinearPoint at = movingLocator_.point(p);
        const Cell in{at.low.x - windowCells_.low.x, at.low.y - windowCells_.low.y};
        if (in.x < 0 || in.y < 0 || at.low.x >= windowCells_.high.x || at.low.y >= windowCells_.high.y)
            return movingBounds_.meets(p, p) ? readSparse(at) : 0.0;
        const float* const below = window_.data() + in.y * windowWidth_ + in.x;
        const float* const above = below + windowWidth_;
        return static_cast<double>(interpolateBilinear(below[0], below[1], above[0], above[1],
                                                       static_cast<float>(at.fx), static_cast<float>(at.fy)));
    }
    /// True where moving things raise or lower the unit cost.
    bool hasMovingCost(Vec2 p) const { return movingCostAt(p) != 0.0; }
    /// The cells of the crowd cost, which are those of the density.
    const Grid& grid() const { return grid_; }
    /// True where the moving cost is negative somewhere: a moving patch is faster than the ground beneath.
    bool hasNegativeCost() const { return negative_; }
    /// True where the cost may differ from zero in the bounding box of the line from `a` to `b`.
    bool meets(Vec2 a, Vec2 b) const {
        return (!crowdCells_.empty() && crowdBounds_.meets(a, b)) || movingCostMeets(a, b);
    }
    /// True where the cost is zero everywhere.
    bool empty() const { return crowdCells_.empty() && movingCells_.empty() && blockedCells_.empty(); }

    /// Relative cost inside moving obstacles, and its upper bound elsewhere.
    static constexpr float kBlocked = 20.0f;
    static constexpr double kMovingCell = 0.25;  ///< Edge of the cells of the moving cost [m].

    /// A box round points; empty at first.
    struct Bounds {
        Vec2 min{1e300, 1e300};
        Vec2 max{-1e300, -1e300};
        /// Extends the box by a square of twice this edge round a centre.
        void extend(Vec2 centre, double cell) {
            min = {centre.x - cell < min.x ? centre.x - cell : min.x,
                   centre.y - cell < min.y ? centre.y - cell : min.y};
            max = {centre.x + cell > max.x ? centre.x + cell : max.x,
                   centre.y + cell > max.y ? centre.y + cell : max.y};
        }
        /// True where the bounding box of the line from a to b meets the box.
        bool meets(Vec2 a, Vec2 b) const {
            return (a.x > min.x || b.x > min.x) && (a.x < max.x || b.x < max.x) &&
                   (a.y > min.y || b.y > min.y) && (a.y < max.y || b.y < max.y);
        }
    };

private:
    /// The two sides of a cell that a direction crosses.
    struct Direction;
    struct Centroid;
    void clear();
    void addCrowd(const Parameters& parameters, const DensityField& density, const Environment& environment);
    void evaluateCrowd(const Parameters& parameters, const DensityField& density,
                       const Environment& environment, std::int32_t cell);
    void setCrowdCost(std::int32_t cell, const CellCost& value);
    void addDiscomfortOf(const Parameters& parameters, const ObstaclePiece& piece);
    void addMovingPatches(const Environment& environment, const CellRect& area);
    void addMovingObstacles(const Environment& environment, double radius);
    void setMovingCost(Cell cell, float value);
    void updateBounds();
    void copyToWindow();
    bool crowdMeets(Vec2 a, Vec2 b) const;
    bool movingCostMeets(Vec2 a, Vec2 b) const {
        return !(movingCells_.empty() && blockedCells_.empty()) && movingBounds_.meets(a, b);
    }
    double readSparse(const BilinearPoint& at) const;
    double crowdAlong(Vec2 a, Vec2 b, double length) const;
    double movingAlong(Vec2 a, Vec2 b, double length, Centroid& centroid) const;
    double sumAlong(Vec2 a, Vec2 b, double length, Centroid& centroid) const;
    double sumOnGround(const StaticGround& ground, Vec2 a, Vec2 b, double length, Centroid& centroid) const;
    double crowdCost(Vec2 p, const Direction& direction) const;
    double crowdCostOnGround(Vec2 p, const Direction& direction, float unitCost) const;
    // The relative speed at which a metre has this relative cost: the inverse of C(f) = alpha + beta / f.
    float speedAt(float relativeCost) const { return timeShare_ / (1.0f + relativeCost - lengthShare_); }

    // Crowd layer.
    Grid grid_;
    BilinearLocator locator_;
    float lengthShare_ = 0.0f;         // alpha / (alpha + beta)
    float timeShare_ = 1.0f;           // beta / (alpha + beta)
    std::vector<CellCost> crowdCost_;  // Relative cost of leaving a cell through its four sides.
    std::vector<float> staticUnit_;    // Unit cost of the static ground at the centres of evaluated_ cells.
    std::vector<std::int32_t> crowdCells_;  // Cells whose crowd cost is not zero.
    CellSet evaluated_;                     // Cells for which the crowd cost was computed.
    CellSet nearCrowd_;                     // Cells of crowdCells_ and their eight neighbours.
    SummedAreaTable nearCrowdSums_;
    Bounds crowdBounds_;  // Bounds of crowdCells_.

    // Moving layer.
    Grid movingGrid_;
    BilinearLocator movingLocator_;
    SparseRaster<float> movingCost_;
    std::vector<Cell> movingCells_;          // Cells whose moving cost is not zero.
    SparseRaster<std::uint8_t> patchCells_;  // 1 for cells under moving patches that are done already.
    bool negative_ = false;                  // True if some moving cost is negative.
    // A copy of these costs row by row in a box round movingCells_, where that is not too large: faster to
    // read.
    CellRect windowCells_{{0, 0}, {-1, -1}};
    std::int32_t windowWidth_ = 0;
    std::vector<float> window_;
    Bounds movingBounds_;  // Bounds of movingCells_ and blocked_.
    Grid ground_;
    // 1 for ground cells where a character would overlap a moving obstacle.
    SparseRaster<std::uint8_t> blocked_;
    std::vector<Cell> blockedCells_;  // The cells set in blocked_.
    Bounds blockedBounds_;
};

/// Discomfort g of one obstacle piece at one point: gain (1 - t / time) (1 - d(t) / range), the maximum over
/// the predicted times t, with d the distance to the piece moved by t; 0 where d exceeds the range at all
/// times. `precision` is the precision of the time of the maximum, relative to the time predicted.
double discomfortAt(const Parameters::Discomfort& def, const ObstaclePiece& piece, Vec2 p,
                    double precision = 1e-9);

/// Raises `discomfort` on the cells in reach of this piece, and appends those that had none to `cells`.
void addDiscomfort(const Parameters::Discomfort& def, const ObstaclePiece& piece, const Grid& grid,
                   std::vector<float>& discomfort, std::vector<std::int32_t>& cells);

}  // namespace muster
