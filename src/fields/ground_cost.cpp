#include "fields/ground_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
// Beside a wall the clearance must rise away from it at least this steeply, or the cell lies between two walls.
constexpr double kLeastSlope = 0.7;
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
        double x = slope(here, at(cell.x + 1, cell.y), at(cell.x - 1, cell.y));
        double y = slope(here, at(cell.x, cell.y + 1), at(cell.x, cell.y - 1));
        const bool wallBeside = x * x + y * y >= kLeastSlope * kLeastSlope * edge * edge;
        if (wallBeside) {
            // Even differences tell the direction better, where both neighbours lie outside.
            x = even(x, at(cell.x + 1, cell.y), at(cell.x - 1, cell.y));
            y = even(y, at(cell.x, cell.y + 1), at(cell.x, cell.y - 1));
        }
        const double steepness = std::sqrt(x * x + y * y);
        const double band = wallBeside ? 0.5 * (std::fabs(x) + std::fabs(y)) / steepness : 0.0;
        // A hair to one side, so that of two cells that lie evenly about the wall only one is drawn to it.
        constexpr double kHair = 1e-4;
        if (depth > band + kHair) return {};
        if (depth < -band + kHair || !wallBeside) return {.free = depth <= 0.0};
        const Vec2 away = Vec2{x, y} / steepness;
        return {true, static_cast<float>(depth * away.x), static_cast<float>(depth * away.y),
                static_cast<float>(away.x), static_cast<float>(away.y)};
    }

private:
    // Outside the grid as at its rim.
    double at(std::int32_t x, std::int32_t y) const {
        return ground_.clearance[ground_.grid.index(
            {std::clamp(x, 0, ground_.grid.width - 1), std::clamp(y, 0, ground_.grid.height - 1)})];
    }

    // Rise of the clearance per cell, looked for on the side where it rises more.
    static double slope(double here, double after, double before) {
        if (after <= here && before <= here) return 0.0;
        return after >= before ? after - here : here - before;
    }

    static double even(double uneven, double after, double before) {
        return after > 0.0 && before > 0.0 ? 0.5 * (after - before) : uneven;
    }

    const GroundRasters& ground_;
    double radius_;
};

float edgeCost(const Node& from, const Node& to, float x, float y, float unit) {
    if (!from.free || !to.free) return kInfinite;
    const float dx = x + to.x - from.x;
    const float dy = y + to.y - from.y;
    return unit * std::max(static_cast<float>(kLeastStep), std::sqrt(dx * dx + dy * dy));
}

}  // namespace

float priceGround(const GroundRasters& ground, double radius, double price, std::vector<CellCost>& cells,
                  std::vector<WallNode>& nodes) {
    const Grid& grid = ground.grid;
    cells.resize(static_cast<std::size_t>(grid.count()));
    nodes.clear();
    const NodeFinder finder(ground, radius);
    float lowest = kInfinite;
    for (std::int32_t y = 0; y < grid.height; ++y) {
        for (std::int32_t x = 0; x < grid.width; ++x) {
            const std::int32_t index = grid.index({x, y});
            CellCost& out = cells[index];
            out = {kInfinite, kInfinite, kInfinite, kInfinite};
            const Node here = finder.find({x, y});
            if (!here.free) continue;
            const auto unit = static_cast<float>(price / ground.travelSpeed[index]);
            lowest = std::min(lowest, unit);
            out.east = edgeCost(here, finder.find({x + 1, y}), 1.0f, 0.0f, unit);
            out.north = edgeCost(here, finder.find({x, y + 1}), 0.0f, 1.0f, unit);
            out.west = edgeCost(here, finder.find({x - 1, y}), -1.0f, 0.0f, unit);
            out.south = edgeCost(here, finder.find({x, y - 1}), 0.0f, -1.0f, unit);
            const bool open = out.east == unit && out.north == unit && out.west == unit && out.south == unit;
            if (!open) nodes.push_back({index, here.x, here.y, here.normalX, here.normalY, unit});
        }
    }
    return lowest < kInfinite ? lowest : static_cast<float>(price);
}

}  // namespace muster
