// The beginning of a march: straight-line costs round the source.
#pragma once

#include "eikonal/front.h"

namespace muster {

/// Fills the surroundings of the source, where the point source would spoil finite differences.
class StartDisc {
public:
    /// Gives values to the cells within `radius` [m] of `source` that a straight line reaches, and to the
    /// nearest free cells where the source's own cell is a wall. On uniform ground all cells within `reach`
    /// [m] that see the source get theirs.
    void start(const UnitCost& cost, Vec2 source, double radius, double reach, Front& front);
    /// Straight-line costs at the cost of the source's cell are right within it [m].
    double radius() const { return radius_; }

private:
    double clearRadius(const UnitCost& cost, Vec2 source, double radius) const;
    void startFromWall(const UnitCost& cost, Vec2 source, Front& front);

    double radius_ = 0.0;
};

/// Cost of a straight step `by` [m] that is priced as in this cell: the length of the step under the metric
/// whose unit circles are those of the upwind scheme. Infinite where both sides along an axis it needs are
/// closed.
double stepCost(const CellCost& cost, Vec2 by);

}  // namespace muster
