#include "cost/ground_cost.h"

#include <algorithm>
#include <cmath>

#include "cost/thin_wall.h"

namespace muster {
namespace {

// Least slope of the clearance away from a wall; where it is flatter the cell lies between two walls.
constexpr double kLeastSlope = 0.7;
// Largest misfit of a model of the clearance that is accepted [cells].
constexpr double kMaxMisfit = 0.05;
// Least length of the edge between two wall nodes [cells].
constexpr double kLeastEdge = 0.1;

// The point of a cell that a cost field holds the value of: the centre, or the wall node.
struct Node {
    bool free = false;     // Whether a character can be there.
    float x = 0.0f;        // From the cell's centre [cells].
    float y = 0.0f;        // From the cell's centre [cells].
    float normalX = 0.0f;  // Unit vector away from the wall; null where the node is the centre.
    float normalY = 0.0f;
};

// Finds the nodes of cells from the clearance around them.
class NodeFinder {
public:
    NodeFinder(const GroundRasters& ground, double radius) : ground_(ground), radius_(radius) {}

    Node find(Cell cell) const {
        if (!ground_.grid.contains(cell)) return {};
        const double edge = ground_.grid.cell;
        const double here = at(cell.x, cell.y);
        const double depth = (radius_ - here) / edge;  // Depth of the centre in the forbidden zone [cells].
        constexpr double kWidestBand = 0.70710678118654752;
        if (depth <= -kWidestBand) return {.free = true};
        if (depth > kWidestBand || !(here > 0.0)) return {};
        Vec2 gradient;
        const bool oneWall = clearanceGradient(cell, depth <= 0.0, gradient);
        const double steepness = length(gradient);
        // In the very middle of a thin wall no side is nearer than the other.
        if (oneWall && !(steepness > 1e-6 * edge)) return {.free = depth <= 0.0};
        // Cells whose centres lie within the band form a 4-connected chain along the wall.
        const double band = oneWall ? 0.5 * (std::fabs(gradient.x) + std::fabs(gradient.y)) / steepness : 0.0;
        // Of two cells whose centres lie symmetrically about the wall only one gets a wall node.
        constexpr double kTieBreak = 1e-4;
        if (depth > band + kTieBreak) return {};
        if (depth < -band + kTieBreak || !oneWall) return {.free = depth <= 0.0};
        const Vec2 away = refineNormal(cell, gradient / steepness);
        return {true, static_cast<float>(depth * away.x), static_cast<float>(depth * away.y),
                static_cast<float>(away.x), static_cast<float>(away.y)};
    }

    // True where the cell and its four neighbours are free and have no wall nodes.
    bool farFromWalls(Cell cell) const {
        constexpr double kCells = 1.75;
        const Grid& grid = ground_.grid;
        return cell.x > 0 && cell.y > 0 && cell.x + 1 < grid.width && cell.y + 1 < grid.height &&
               ground_.clearance[grid.index(cell)] > radius_ + kCells * grid.cell;
    }

private:
    // The clearance of a cell; beyond the grid's edge that of the nearest cell.
    double at(std::int32_t x, std::int32_t y) const {
        return ground_.clearance[ground_.grid.index(
            {std::clamp(x, 0, ground_.grid.width - 1), std::clamp(y, 0, ground_.grid.height - 1)})];
    }

    // The gradient of the clearance per cell at a cell near one wall; false where the cell lies between two
    // walls. For a centre that is free the gradient towards its own wall is accepted there.
    bool clearanceGradient(Cell cell, bool free, Vec2& gradient) const {
        const double here = at(cell.x, cell.y);
        const double east = at(cell.x + 1, cell.y);
        const double west = at(cell.x - 1, cell.y);
        const double north = at(cell.x, cell.y + 1);
        const double south = at(cell.x, cell.y - 1);
        const double least = kLeastSlope * kLeastSlope * ground_.grid.cell * ground_.grid.cell;
        gradient = {risingSlope(here, east, west), risingSlope(here, north, south)};
        if (lengthSquared(gradient) >= least) {
            // Central differences give the direction better where both neighbours lie outside obstacles.
            gradient = {centralSlope(gradient.x, east, west), centralSlope(gradient.y, north, south)};
            return true;
        }
        if (free) gradient = {fallingSlope(here, east, west), fallingSlope(here, north, south)};
        return free && lengthSquared(gradient) >= least;
    }

    // One-sided difference along an axis, on the side where the clearance rises more; 0 at a maximum.
    static double risingSlope(double here, double after, double before) {
        if (after <= here && before <= here) return 0.0;
        return after >= before ? after - here : here - before;
    }

    // The same on the side where the clearance falls more; 0 at a minimum.
    static double fallingSlope(double here, double after, double before) {
        if (after >= here && before >= here) return 0.0;
        return after <= before ? after - here : here - before;
    }

    static double centralSlope(double oneSided, double after, double before) {
        return after > 0.0 && before > 0.0 ? 0.5 * (after - before) : oneSided;
    }

    // Estimates of the clearance's slope along one axis [cells per cell].
    struct Slope {
        double wall = 0.0;         // One-sided, before a straight wall: the clearance is linear.
        double corner = 0.0;       // One-sided, round a corner: the clearance squared is quadratic.
        double central = 0.0;      // Exact for both where both neighbours lie outside obstacles.
        bool bothOutside = false;  // Whether both neighbours do.
        std::int32_t outer = 0;    // The side, 1 or -1, on which the clearance is higher.
    };
    Slope slopeOf(double here, Cell after, Cell before) const {
        const double edge = ground_.grid.cell;
        const double a = ground_.grid.contains(after) ? at(after.x, after.y) / edge : 0.0;
        const double b = ground_.grid.contains(before) ? at(before.x, before.y) / edge : 0.0;
        const double higher = std::max(a, b);
        const double side = a >= b ? 1.0 : -1.0;
        return {side * (higher - here), side * (higher * higher - here * here - 1.0) / (2.0 * here),
                (a * a - b * b) / (4.0 * here), a > 0.0 && b > 0.0, a >= b ? 1 : -1};
    }

    // A better normal than the gradient of the clearance: that of a straight wall or of a corner, whichever
    // fits the neighbours and the diagonal neighbour outside; `coarse` where none fits. The clearance rises
    // by a metre per metre, so that the slopes of a good model have length 1.
    Vec2 refineNormal(Cell cell, Vec2 coarse) const {
        const double here = at(cell.x, cell.y) / ground_.grid.cell;
        const Slope x = slopeOf(here, {cell.x + 1, cell.y}, {cell.x - 1, cell.y});
        const Slope y = slopeOf(here, {cell.x, cell.y + 1}, {cell.x, cell.y - 1});
        const double diagonal = at(cell.x + x.outer, cell.y + y.outer) / ground_.grid.cell;
        double best = kMaxMisfit;
        Vec2 found = coarse;
        const auto tryModel = [&](Vec2 slope, bool corner) {
            const double rise = slope.x * x.outer + slope.y * y.outer;
            const double expected = corner ? std::sqrt(std::max(0.0, here * here + 2.0 * here * rise + 2.0))
                                           : here + rise;
            const double misfit = std::fabs(lengthSquared(slope) - 1.0) + std::fabs(diagonal - expected);
            if (!(misfit < best)) return;
            best = misfit;
            found = slope;
        };
        tryModel({x.bothOutside ? x.central : x.wall, y.bothOutside ? y.central : y.wall}, false);
        tryModel({x.bothOutside ? x.central : x.corner, y.bothOutside ? y.central : y.corner}, true);
        tryModel({x.wall, y.wall}, false);
        tryModel({x.corner, y.corner}, true);
        return normalized(found);
    }

    const GroundRasters& ground_;
    double radius_;
};

float edgeCost(const Node& from, const Node& to, float x, float y, float unit) {
    if (!from.free || !to.free) return kUnreachableCost;
    const float dx = x + to.x - from.x;
    const float dy = y + to.y - from.y;
    if (crossesThinWall(from, to, dx, dy)) return kUnreachableCost;
    return unit * std::max(static_cast<float>(kLeastEdge), std::sqrt(dx * dx + dy * dy));
}

void computeCell(const GroundRasters& ground, const NodeFinder& finder, double openCost, std::int32_t index,
                 const GroundCosts& costs) {
    const Cell cell = ground.grid.at(index);
    CellCost& out = costs.cells[index];
    if (finder.farFromWalls(cell)) {
        const auto unit = static_cast<float>(openCost / ground.travelSpeed[index]);
        costs.unit[index] = unit;
        out = {unit, unit, unit, unit};
        return;
    }
    out = {kUnreachableCost, kUnreachableCost, kUnreachableCost, kUnreachableCost};
    costs.unit[index] = kUnreachableCost;
    const Node here = finder.find(cell);
    if (!here.free) return;
    const auto unit = static_cast<float>(openCost / ground.travelSpeed[index]);
    costs.unit[index] = unit;
    out.east = edgeCost(here, finder.find({cell.x + 1, cell.y}), 1.0f, 0.0f, unit);
    out.north = edgeCost(here, finder.find({cell.x, cell.y + 1}), 0.0f, 1.0f, unit);
    out.west = edgeCost(here, finder.find({cell.x - 1, cell.y}), -1.0f, 0.0f, unit);
    out.south = edgeCost(here, finder.find({cell.x, cell.y - 1}), 0.0f, -1.0f, unit);
    const bool open = out.east == unit && out.north == unit && out.west == unit && out.south == unit;
    if (!open) costs.nodes.push_back({index, here.x, here.y, here.normalX, here.normalY, unit});
}

}  // namespace

void computeGroundCost(const GroundRasters& ground, double radius, double openCost, std::int32_t first,
                       std::int32_t last, const GroundCosts& costs) {
    const NodeFinder finder(ground, radius);
    for (std::int32_t index = first; index < last; ++index)
        computeCell(ground, finder, openCost, index, costs);
}

void computeGroundCost(const GroundRasters& ground, double radius, double openCost,
                       std::span<const std::int32_t> cells, const GroundCosts& costs) {
    const NodeFinder finder(ground, radius);
    for (const std::int32_t index : cells) computeCell(ground, finder, openCost, index, costs);
}

}  // namespace muster
