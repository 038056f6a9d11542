// The route to an area, or on towards a heading: one cost field for all people who take it
// (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "muster/geometry.h"

namespace muster {

/// Cost and direction of the route from a point.
struct GoalWay {
    /// Cost of the rest of the route [m of open ground]; 0 in the area, infinite where there is none.
    double cost = 0.0;
    Vec2 direction;  ///< Unit vector along the route; null in the area and where there is none.
};

/// The cost of the cheapest route over the static ground to an area, from every point.
class GoalField {
public:
    /// Solves the field of a polygon. The ground must outlive the field.
    void solve(const StaticGround& ground, const UnitCost& unitCost, const Polygon& polygon,
               EikonalSolver& solver);
    /// Solves the field of a polyline.
    void solveToLine(const StaticGround& ground, const UnitCost& unitCost, std::span<const Vec2> line,
                     EikonalSolver& solver);
    /// Solves the field of all people who walk on towards a heading, a unit vector, up to the sides of the
    /// ground. If `ring`, the direction does not end there.
    void solveHeading(const StaticGround& ground, const UnitCost& unitCost, Vec2 heading, bool ring,
                      EikonalSolver& solver);

    /// The route from a point: straight where the nearest point of the area is in sight, else down the field.
    GoalWay at(Vec2 p) const;
    /// The route of a person who keeps `wallGap` [m] farther from walls than it must: that of a point which
    /// is nearer to the walls.
    GoalWay at(Vec2 p, double wallGap) const;
    /// The cost of the route from a point.
    double cost(Vec2 p) const;
    /// The ground for which the field was solved.
    const StaticGround& ground() const { return *ground_; }
    /// Width of the narrowest part of the route within a cost, for centres of bodies [m].
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
    Polygon polygon_;  // The area's polygon, or the line.
    Box box_;          // Bounds of the polygon.
    bool isLine_ = false;
    Vec2 heading_;  // Heading; null for an area.
    bool ring_ = false;
    std::vector<FieldSeed> seeds_;
    std::vector<double> area_;  // Area by cost [m^2].
    std::vector<float> width_;  // Least length of the front up to each multiple of kCostStep [m].
};

}  // namespace muster
