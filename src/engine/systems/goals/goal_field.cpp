#include "engine/systems/goals/goal_field.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

constexpr double kCostStep = 0.5;     // Cost between two measurements of the width [m].
constexpr double kClearRatio = 1.05;  // Ratio of cost to straight line above which the line is not clear...
constexpr double kClearCells = 1.0;   // ... if the difference is also above this [cells].
constexpr double kTraceReach = 3.0;   // Distance to an area within which the line to it is traced [m].
// Cost to an area below which a person keeps no extra distance to walls [m].
constexpr double kStraightCost = 1.0;
constexpr double kWallReach = 2.5;  // Greatest clearance that counts as a distance to walls [m].
constexpr double kSlopeStep = 0.5;  // Distance between readings of the clearance for its gradient [m].
// Cells beside an area from which it is entered where no cell lies in it.
constexpr std::int32_t kEntryCells = 2;

float unitOf(const CellCost& cost) {
    return std::min({cost.east, cost.north, cost.west, cost.south});
}

}  // namespace

void GoalField::begin(const StaticGround& ground) {
    ground_ = &ground;
    seeds_.clear();
    width_.clear();
    heading_ = {};
    ring_ = isLine_ = false;
}

bool GoalField::holds(Vec2 p) const {
    return !isLine_ && box_.contains(p) && containsPoint(polygon_, p);
}

Vec2 GoalField::nearest(Vec2 p) const {
    if (!isLine_) return closestOnBoundary(polygon_, p).point;
    Vec2 best = polygon_.front();
    for (std::size_t k = 1; k < polygon_.size(); ++k) {
        const Vec2 q = closestOnSegment(polygon_[k - 1], polygon_[k], p);
        if (lengthSquared(q - p) < lengthSquared(best - p)) best = q;
    }
    return best;
}

// The free cells in the area cost nothing; others go straight to those at its rim.
void GoalField::seedArea(const UnitCost& unitCost) {
    const Grid& grid = unitCost.grid;
    const Cell low = grid.nearestCell(box_.min), high = grid.nearestCell(box_.max);
    const auto inside = [&](Cell c) { return holds(grid.centre(c)); };
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            if (unitCost.wall(grid.index({x, y})) || !inside({x, y})) continue;
            const bool rim = !inside({x - 1, y}) || !inside({x + 1, y}) || !inside({x, y - 1}) ||
                             !inside({x, y + 1});
            seeds_.push_back({{x, y}, 0.0, rim ? FieldSeed::Kind::Source : FieldSeed::Kind::Fixed});
        }
}

// A line, or an area that holds the centre of no free cell, is entered from the cells beside it.
void GoalField::seedBeside(const UnitCost& unitCost) {
    const Grid& grid = unitCost.grid;
    const double reach = kEntryCells * grid.cell;
    const Box near = box_.grown(reach);
    const Cell low = grid.nearestCell(near.min), high = grid.nearestCell(near.max);
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const std::int32_t cell = grid.index({x, y});
            const Vec2 p = grid.centre({x, y}), q = nearest(p);
            const double away = distance(p, q);
            if (unitCost.wall(cell) || away > reach || !ground_->collisionFree(p, q)) continue;
            seeds_.push_back({{x, y}, away * unitOf(unitCost.cells[cell]), FieldSeed::Kind::Source});
        }
}

void GoalField::solve(const StaticGround& ground, const UnitCost& unitCost, const Polygon& polygon,
                      EikonalSolver& solver) {
    begin(ground);
    polygon_ = polygon;
    box_ = boundsOf(polygon);
    seedArea(unitCost);
    if (seeds_.empty()) seedBeside(unitCost);
    solver.solve(unitCost, seeds_, field_);
    measureWidths();
}

void GoalField::solveToLine(const StaticGround& ground, const UnitCost& unitCost, std::span<const Vec2> line,
                            EikonalSolver& solver) {
    begin(ground);
    isLine_ = true;
    polygon_.assign(line.begin(), line.end());
    box_ = boundsOf(polygon_);
    seedBeside(unitCost);
    solver.solve(unitCost, seeds_, field_);
}

// A plane wave from the outermost cells on the far sides: on open ground everyone goes along the heading.
void GoalField::solveHeading(const StaticGround& ground, const UnitCost& unitCost, Vec2 heading, bool ring,
                             EikonalSolver& solver) {
    begin(ground);
    heading_ = heading;
    ring_ = ring;
    polygon_.clear();
    const Grid& grid = unitCost.grid;
    const auto along = [&](Cell c) { return dot(grid.centre(c), heading); };
    double farthest = -kInfiniteCost;
    const auto add = [&](Cell c) {
        if (unitCost.wall(grid.index(c))) return false;
        seeds_.push_back({c, 0.0, FieldSeed::Kind::Front});
        farthest = std::max(farthest, along(c));
        return true;
    };
    constexpr double kAcross = 1e-6;
    // The first free cell of each row and column, as seen from the far side.
    for (std::int32_t y = 0; y < grid.height && std::fabs(heading.x) > kAcross; ++y)
        for (std::int32_t k = 0; k < kEntryCells + 2; ++k)
            if (add({heading.x > 0.0 ? grid.width - 1 - k : k, y})) break;
    for (std::int32_t x = 0; x < grid.width && std::fabs(heading.y) > kAcross; ++x)
        for (std::int32_t k = 0; k < kEntryCells + 2; ++k)
            if (add({x, heading.y > 0.0 ? grid.height - 1 - k : k})) break;
    for (FieldSeed& seed : seeds_)
        seed.cost = (farthest - along(seed.cell)) * unitOf(unitCost.cells[grid.index(seed.cell)]);
    solver.solve(unitCost, seeds_, field_);
}

// The set of points at equal cost s has length dA/ds, where A is the area within s (the coarea formula).
void GoalField::measureWidths() {
    const Grid& grid = field_.grid();
    area_.clear();
    for (std::int32_t y = 0; y < grid.height; ++y)
        for (std::int32_t x = 0; x < grid.width; ++x) {
            const float cost = field_.value({x, y});
            if (!(cost > 0.0f) || !(cost < kUnreachableCost)) continue;
            const auto bin = static_cast<std::size_t>(cost / kCostStep);
            if (bin >= area_.size()) area_.resize(bin + 1, 0.0);
            const float unit = ground_->unitCost(grid.centre({x, y}));
            area_[bin] += grid.cell * grid.cell * unit;
        }
    double least = kInfiniteCost;
    for (const double a : area_) width_.push_back(static_cast<float>(least = std::min(least, a / kCostStep)));
}

double GoalField::width(double cost) const {
    if (width_.empty()) return 0.0;
    // The area of the cost's own bin may be cut off by what lies behind, so that the bin before is read.
    const double bins = std::min(std::max(cost, 0.0) / kCostStep, static_cast<double>(width_.size()));
    return width_[static_cast<std::size_t>(std::max(0.0, bins - 1.0))];
}

double GoalField::cost(Vec2 p) const {
    return holds(p) ? 0.0 : field_.cost(p);
}

// The wave of a heading ends at the sides of the ground; at a joined side the heading leads on.
GoalWay GoalField::along(Vec2 p) const {
    const FieldWay way = field_.way(p);
    const Box box = field_.grid().box();
    const double left = heading_.x > 0.0 ? box.max.x - p.x : p.x - box.min.x;
    const bool atSide = left < ground_->radius() + kEntryCells * field_.grid().cell;
    const bool goesOn = ring_ && (atSide || (way.direction == Vec2{} && way.cost < kInfiniteCost));
    return {way.cost, goesOn ? heading_ : way.direction};
}

GoalWay GoalField::at(Vec2 p) const {
    if (polygon_.empty()) return along(p);
    if (holds(p)) return {};
    const FieldWay way = field_.way(p);
    const Vec2 q = nearest(p);
    const double away = distance(p, q), straight = away * ground_->unitCost(p);
    // Far away the field knows whether the line is clear; near the area it is looked at.
    const bool isNear = away < kTraceReach;
    const bool alike = way.cost <= kClearRatio * straight + kClearCells * field_.grid().cell;
    if (alike && (isNear ? ground_->lineOfSight(p, q, away) : way.straight))
        return {straight, normalized(q - p)};
    if (!(way.cost < kInfiniteCost)) return {kInfiniteCost, {}};
    return {way.cost, way.direction == Vec2{} ? normalized(q - p) : way.direction};
}

// Moves a point down the gradient of the clearance, which vanishes half way between two walls.
Vec2 GoalField::nearerToWalls(Vec2 p, double by) const {
    if (ground_->uniformClearance(p) > kWallReach) return p;
    const double free = ground_->interpolatedClearance(p);
    if (free <= 0.0 || free > kWallReach) return p;
    const auto clearance = [&](Vec2 at) {
        return std::clamp(ground_->interpolatedClearance(at), 0.0, kWallReach);
    };
    const Vec2 x{kSlopeStep, 0.0}, y{0.0, kSlopeStep};
    const Vec2 slope{clearance(p + x) - clearance(p - x), clearance(p + y) - clearance(p - y)};
    return p - slope * (std::min(by, free) / (2.0 * kSlopeStep));
}

GoalWay GoalField::at(Vec2 p, double wallGap) const {
    const GoalWay way = at(p);
    if (!(wallGap > 0.0) || way.cost < kStraightCost || !(way.cost < kInfiniteCost)) return way;
    const Vec2 q = nearerToWalls(p, wallGap);
    if (q == p) return way;
    const GoalWay beside = at(q);
    return beside.direction == Vec2{} || !ground_->collisionFree(p, q) ? way
                                                                       : GoalWay{way.cost, beside.direction};
}

}  // namespace muster
