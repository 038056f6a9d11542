// Initialisation of a front near its source, where the singularity of a point source would spoil finite
// differences.
#pragma once

#include "engine/fields/eikonal/front.h"

namespace muster {

/// Gives cells near the source their first values.
class SourceInitialiser {
public:
    /// On uniform ground, sets the values of all cells within `reach` [m] that see the source. Otherwise sets
    /// the cells within `radius` [m] of `source` that a straight line reaches. Where the source lies in a
    /// wall, sets the nearest free cells.
    void start(const UnitCost& cost, Vec2 source, double radius, double reach, Front& front);
    /// Within this distance of the source [m] all ground has the unit cost of the source's cell.
    double radius() const { return radius_; }

private:
    double uniformRadius(const UnitCost& cost, Vec2 source, double radius) const;
    void startOnVaryingGround(const UnitCost& cost, Vec2 source, double radius, std::int32_t index,
                              Front& front) const;
    void startFromWall(const UnitCost& cost, Vec2 source, Front& front) const;

    double radius_ = 0.0;
};

/// Cost of the straight step `by` [m] over ground with these unit costs: the length of the step in the metric
/// that the upwind scheme discretises. Infinite where both sides along an axis that it needs are closed.
double stepCost(const CellCost& cost, Vec2 by);

}  // namespace muster
