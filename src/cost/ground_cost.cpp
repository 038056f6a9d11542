#include "cost/ground_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cost/thin_wall.h"

namespace muster {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
// Beside a wall the clearance must rise away from it at least this steeply, or the cell lies between two
// walls.
constexpr double kLeastSlope = 0.7;
// Slopes fit where they are off by less than this.
constexpr double kFits = 0.05;
// Two nodes drawn to the wall keep at least this distance, in cells.
constexpr double kLeastStep = 0.1;

// Where the node of a cell stands, relative to its centre [cells].
struct Node {
    bool free = false;
    float x = 0.0f;
    float y = 0.0f;
    float normalX = 0.0f;  // Away from the wall it was drawn to.
    float normalY = 0.0f;
};

class NodeFinder {
public:
    NodeFinder(const GroundRasters& ground, double radius) : ground_(ground), radius_(radius) {}

    Node find(Cell cell) const {
        if (!ground_.grid.contains(cell)) return {};
        const double edge = ground_.grid.cell;
        const double here = at(cell.x, cell.y);
        const double depth = (radius_ - here) / edge;  // Of the centre in the forbidden zone, in cells.
        constexpr double kWidestBand = 0.70710678118654752;
        if (depth <= -kWidestBand) return {.free = true};
        if (depth > kWidestBand || !(here > 0.0)) return {};
        Vec2 rise;
        const bool wallBeside = riseFromWall(cell, depth <= 0.0, rise);
        const double steepness = length(rise);
        // In the very middle of a thin wall there is no side to be drawn to.
        if (wallBeside && !(steepness > 1e-6 * edge)) return {.free = depth <= 0.0};
        const double band = wallBeside ? 0.5 * (std::fabs(rise.x) + std::fabs(rise.y)) / steepness : 0.0;
        // A hair to one side, so that of two cells that lie evenly about the wall only one is drawn to it.
        constexpr double kHair = 1e-4;
        if (depth > band + kHair) return {};
        if (depth < -band + kHair || !wallBeside) return {.free = depth <= 0.0};
        const Vec2 away = refined(cell, rise / steepness);
        return {true, static_cast<float>(depth * away.x), static_cast<float>(depth * away.y),
                static_cast<float>(away.x), static_cast<float>(away.y)};
    }

    // True where the cell and the four beside it are free, and none is drawn to a wall.
    bool farFromWalls(Cell cell) const {
        constexpr double kCells = 1.75;
        const Grid& grid = ground_.grid;
        return cell.x > 0 && cell.y > 0 && cell.x + 1 < grid.width && cell.y + 1 < grid.height &&
               ground_.clearance[grid.index(cell)] > radius_ + kCells * grid.cell;
    }

private:
    // Outside the grid as at its rim.
    double at(std::int32_t x, std::int32_t y) const {
        return ground_.clearance[ground_.grid.index(
            {std::clamp(x, 0, ground_.grid.width - 1), std::clamp(y, 0, ground_.grid.height - 1)})];
    }

    // The rise of the clearance per cell away from the wall beside a cell; false where it lies between two.
    // Of a cell that is free even so the slope towards its own wall counts there.
    bool riseFromWall(Cell cell, bool free, Vec2& rise) const {
        const double here = at(cell.x, cell.y);
        const double east = at(cell.x + 1, cell.y);
        const double west = at(cell.x - 1, cell.y);
        const double north = at(cell.x, cell.y + 1);
        const double south = at(cell.x, cell.y - 1);
        const double least = kLeastSlope * kLeastSlope * ground_.grid.cell * ground_.grid.cell;
        rise = {slope(here, east, west), slope(here, north, south)};
        if (lengthSquared(rise) >= least) {
            // Even differences tell the direction better, where both neighbours lie outside.
            rise = {even(rise.x, east, west), even(rise.y, north, south)};
            return true;
        }
        if (free) rise = {innerSlope(here, east, west), innerSlope(here, north, south)};
        return free && lengthSquared(rise) >= least;
    }

    // Rise of the clearance per cell, looked for on the side where it rises more.
    static double slope(double here, double after, double before) {
        if (after <= here && before <= here) return 0.0;
        return after >= before ? after - here : here - before;
    }

    // The same on the side where it falls more.
    static double innerSlope(double here, double after, double before) {
        if (after >= here && before >= here) return 0.0;
        return after <= before ? after - here : here - before;
    }

    static double even(double uneven, double after, double before) {
        return after > 0.0 && before > 0.0 ? 0.5 * (after - before) : uneven;
    }

    // A slope of the clearance [cells per cell] by the value here and at one side, or both: `wall` as before
    // a straight wall (clearance linear), `corner` as round a corner (its square quadratic); `outer` is the
    // side where it is higher.
    struct Slope {
        double wall = 0.0;
        double corner = 0.0;
        double even = 0.0;  // Right at both, where both neighbours are outside.
        bool bothOut = false;
        std::int32_t outer = 0;
    };
    Slope slopeOf(double here, Cell after, Cell before) const {
        const double edge = ground_.grid.cell;
        const double a = ground_.grid.contains(after) ? at(after.x, after.y) / edge : 0.0;
        const double b = ground_.grid.contains(before) ? at(before.x, before.y) / edge : 0.0;
        const double beside = std::max(a, b);
        const double side = a >= b ? 1.0 : -1.0;
        return {side * (beside - here), side * (beside * beside - here * here - 1.0) / (2.0 * here),
                (a * a - b * b) / (4.0 * here), a > 0.0 && b > 0.0, a >= b ? 1 : -1};
    }

    // A better direction in which the clearance rises: as before a wall or round a corner, whichever fits, as
    // it rises by a metre per metre and the cell across is a fourth witness; the coarse one where none fits.
    Vec2 refined(Cell cell, Vec2 coarse) const {
        const double here = at(cell.x, cell.y) / ground_.grid.cell;
        const Slope x = slopeOf(here, {cell.x + 1, cell.y}, {cell.x - 1, cell.y});
        const Slope y = slopeOf(here, {cell.x, cell.y + 1}, {cell.x, cell.y - 1});
        const double across = at(cell.x + x.outer, cell.y + y.outer) / ground_.grid.cell;
        double best = kFits;
        Vec2 found = coarse;
        const auto offer = [&](Vec2 slope, bool corner) {
            const double rise = slope.x * x.outer + slope.y * y.outer;
            const double expected = corner ? std::sqrt(std::max(0.0, here * here + 2.0 * here * rise + 2.0))
                                           : here + rise;
            const double misfit = std::fabs(lengthSquared(slope) - 1.0) + std::fabs(across - expected);
            if (!(misfit < best)) return;
            best = misfit;
            found = slope;
        };
        offer({x.bothOut ? x.even : x.wall, y.bothOut ? y.even : y.wall}, false);
        offer({x.bothOut ? x.even : x.corner, y.bothOut ? y.even : y.corner}, true);
        offer({x.wall, y.wall}, false);
        offer({x.corner, y.corner}, true);
        return normalized(found);
    }

    const GroundRasters& ground_;
    double radius_;
};

float edgeCost(const Node& from, const Node& to, float x, float y, float unit) {
    if (!from.free || !to.free) return kInfinite;
    const float dx = x + to.x - from.x;
    const float dy = y + to.y - from.y;
    if (throughThinWall(from, to, dx, dy)) return kInfinite;
    return unit * std::max(static_cast<float>(kLeastStep), std::sqrt(dx * dx + dy * dy));
}

void priceCell(const GroundRasters& ground, const NodeFinder& finder, double price, std::int32_t index,
               const GroundCosts& costs) {
    const Cell cell = ground.grid.at(index);
    CellCost& out = costs.cells[index];
    if (finder.farFromWalls(cell)) {
        const auto unit = static_cast<float>(price / ground.travelSpeed[index]);
        costs.unit[index] = unit;
        out = {unit, unit, unit, unit};
        return;
    }
    out = {kInfinite, kInfinite, kInfinite, kInfinite};
    costs.unit[index] = kInfinite;
    const Node here = finder.find(cell);
    if (!here.free) return;
    const auto unit = static_cast<float>(price / ground.travelSpeed[index]);
    costs.unit[index] = unit;
    out.east = edgeCost(here, finder.find({cell.x + 1, cell.y}), 1.0f, 0.0f, unit);
    out.north = edgeCost(here, finder.find({cell.x, cell.y + 1}), 0.0f, 1.0f, unit);
    out.west = edgeCost(here, finder.find({cell.x - 1, cell.y}), -1.0f, 0.0f, unit);
    out.south = edgeCost(here, finder.find({cell.x, cell.y - 1}), 0.0f, -1.0f, unit);
    const bool open = out.east == unit && out.north == unit && out.west == unit && out.south == unit;
    if (!open) costs.nodes.push_back({index, here.x, here.y, here.normalX, here.normalY, unit});
}

}  // namespace

void priceGround(const GroundRasters& ground, double radius, double price, std::int32_t first,
                 std::int32_t last, const GroundCosts& costs) {
    const NodeFinder finder(ground, radius);
    for (std::int32_t index = first; index < last; ++index) priceCell(ground, finder, price, index, costs);
}

void priceGround(const GroundRasters& ground, double radius, double price,
                 std::span<const std::int32_t> cells, const GroundCosts& costs) {
    const NodeFinder finder(ground, radius);
    for (const std::int32_t index : cells) priceCell(ground, finder, price, index, costs);
}

}  // namespace muster
