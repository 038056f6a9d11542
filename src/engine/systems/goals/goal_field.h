// The way to an area, or on towards a heading: one cost field for all who go there (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "muster/geometry.h"

namespace muster {

/// What a field says at a point.
struct GoalWay {
    double cost = 0.0;  ///< Of the way that is left [m of open ground]; 0 in the area, infinite where there
                        ///< is none.
    Vec2 direction;     ///< Unit vector along it; null in the area and where there is none.
};

/// The cost of the cheapest way over the static ground to an area, from everywhere.
class GoalField {
public:
    /// Solves the field of a polygon. The ground must outlive the field.
    void solve(const StaticGround& ground, const UnitCost& unitCost, const Polygon& polygon,
               EikonalSolver& solver);
    /// The same to a polyline.
    void solveToLine(const StaticGround& ground, const UnitCost& unitCost, std::span<const Vec2> line,
                     EikonalSolver& solver);
    /// Solves the field of all who walk on towards a heading, a unit vector, up to the sides of the ground.
    /// The direction does not end there if `ring`.
    void solveHeading(const StaticGround& ground, const UnitCost& unitCost, Vec2 heading, bool ring,
                      EikonalSolver& solver);

    /// The way from a point. Straight where the nearest point of the area is in sight, else down the field.
    GoalWay at(Vec2 p) const;
    /// The same for somebody who keeps by so much farther from walls than it must [m]: its way is that of a
    /// point which is nearer to them.
    GoalWay at(Vec2 p, double wallGap) const;
    /// Only its cost.
    double cost(Vec2 p) const;
    /// The ground for which it was solved.
    const StaticGround& ground() const { return *ground_; }
    /// Width of the narrowest part of the way within a cost, for centres of bodies [m].
    double width(double cost) const;

private:
    void begin(const StaticGround& ground);
    void seedArea(const UnitCost& unitCost);
    void seedBeside(const UnitCost& unitCost);
    void measureWidths();
    GoalWay along(Vec2 p) const;
    Vec2 nearerToWalls(Vec2 p, double by) const;
    bool holds(Vec2 p) const;
    Vec2 nearest(Vec2 p) const;

    const StaticGround* ground_ = nullptr;
    CostField field_;
    Polygon polygon_;  // Of the area, or the line.
    Box box_;          // Round it.
    bool isLine_ = false;
    Vec2 heading_;  // Null for an area.
    bool ring_ = false;
    std::vector<FieldSeed> seeds_;
    std::vector<double> area_;  // By cost [m^2].
    std::vector<float> width_;  // Least length of the front up to each multiple of kBin [m].
};

}  // namespace muster
