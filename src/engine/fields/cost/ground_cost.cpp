#include "engine/fields/cost/ground_cost.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/fields/cost/ground_node.h"

namespace muster {
namespace {

// Least length of the edge between two wall nodes [cells].
constexpr double kLeastEdge = 0.1;
// Bits of open_: all edges are open, and the cell is narrow.
constexpr std::uint8_t kEdgesOpen = 0x0f, kNarrow = 0x10;

float edgeCost(const GroundNode& from, const GroundNode& to, float x, float y, float unit) {
    if (!from.free || !to.free) return kUnreachableCost;
    const float dx = x + to.x - from.x;
    const float dy = y + to.y - from.y;
    if (crossesThinWall(from, to, dx, dy)) return kUnreachableCost;
    return unit * std::max(static_cast<float>(kLeastEdge), std::sqrt(dx * dx + dy * dy));
}

// The cost of a cell of ground of this unit cost from its node and those of its neighbours: `nodes[k]` of the
// cell, to the east, north, west and south.
CellCost edgesOf(const GroundNode& here, const GroundNode& east, const GroundNode& north,
                 const GroundNode& west, const GroundNode& south, float unit) {
    return {edgeCost(here, east, 1.0f, 0.0f, unit), edgeCost(here, north, 0.0f, 1.0f, unit),
            edgeCost(here, west, -1.0f, 0.0f, unit), edgeCost(here, south, 0.0f, -1.0f, unit)};
}

bool isOpen(const CellCost& cost, float unit) {
    return cost.east == unit && cost.north == unit && cost.west == unit && cost.south == unit;
}

void computeCell(const GroundRasters& ground, const GroundNodeFinder& finder, double openCost,
                 std::int32_t index, const GroundCosts& costs) {
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
    const GroundNode here = finder.find(cell);
    if (!here.free) return;
    const auto unit = static_cast<float>(openCost / ground.travelSpeed[index]);
    costs.unit[index] = unit;
    out = edgesOf(here, finder.find({cell.x + 1, cell.y}), finder.find({cell.x, cell.y + 1}),
                  finder.find({cell.x - 1, cell.y}), finder.find({cell.x, cell.y - 1}), unit);
    if (!isOpen(out, unit)) costs.nodes.push_back({index, here.x, here.y, here.normalX, here.normalY, unit});
}

}  // namespace

void computeGroundCost(const GroundRasters& ground, double radius, double openCost, std::int32_t first,
                       std::int32_t last, const GroundCosts& costs) {
    const GroundNodeFinder finder(ground, radius);
    for (std::int32_t index = first; index < last; ++index)
        computeCell(ground, finder, openCost, index, costs);
}

void computeGroundCost(const GroundRasters& ground, double radius, double openCost,
                       std::span<const std::int32_t> cells, const GroundCosts& costs) {
    const GroundNodeFinder finder(ground, radius);
    for (const std::int32_t index : cells) computeCell(ground, finder, openCost, index, costs);
}

void GroundCostCrop::findNodes(const GroundRasters& ground, double radius, const CellRect& area) {
    const GroundNodeFinder finder(ground, radius);
    const CellRect whole{{0, 0}, {ground.grid.width - 1, ground.grid.height - 1}};
    nodes_.assign(ground.grid.count(), {});
    // Cells far from walls need no search.
    const CellRect around = whole.common(
        {{area.low.x - 1, area.low.y - 1}, {area.high.x + 1, area.high.y + 1}});
    for (std::int32_t y = around.low.y; y <= around.high.y; ++y)
        for (std::int32_t x = around.low.x; x <= around.high.x; ++x)
            nodes_[ground.grid.index({x, y})] = finder.find({x, y});
}

// Fronts and lines of sight pass no wall, so they pass no gap whose cells are walls.
void GroundCostCrop::closeGaps(const Grid& grid, std::span<const ClosedGap> gaps) {
    for (const ClosedGap& gap : gaps) {
        // Half a cell more at either end, where the gap ends in an obstacle.
        const Vec2 more = normalized(gap.b - gap.a) * (0.5 * grid.cell);
        const Vec2 from = gap.a - more, to = gap.b + more;
        const auto samples = static_cast<std::int32_t>(4.0 * distance(from, to) / grid.cell) + 1;
        for (std::int32_t k = 0; k <= samples; ++k) {
            const Cell c = grid.cellOf(lerp(from, to, static_cast<double>(k) / samples));
            if (grid.contains(c)) nodes_[grid.index(c)] = {};
        }
    }
}

void GroundCostCrop::openNarrow(const Grid& grid, std::span<const NarrowCell> narrow) {
    open_.clear();
    if (narrow.empty()) return;
    open_.assign(grid.count(), kEdgesOpen);
    for (const NarrowCell& cell : narrow) {
        open_[cell.cell] = cell.open;
        if (cell.keepsNode()) continue;
        nodes_[cell.cell] = {.free = true, .x = cell.x, .y = cell.y};
        open_[cell.cell] |= kNarrow;
    }
}

// Closes the edges of a cell over which no walk leads from or to a narrow one. True where this cell or one
// next to it is narrow.
bool GroundCostCrop::closeEdges(const Grid& grid, Cell cell, CellCost& cost) const {
    if (open_.empty()) return false;
    const std::uint8_t here = open_[grid.index(cell)];
    bool narrow = (here & kNarrow) != 0;
    float* const edges[] = {&cost.east, &cost.north, &cost.west, &cost.south};
    for (std::uint32_t k = 0; k < std::size(kNarrowSteps); ++k) {
        const Cell other{cell.x + kNarrowSteps[k].x, cell.y + kNarrowSteps[k].y};
        if (!grid.contains(other)) continue;
        const std::uint8_t there = open_[grid.index(other)];
        narrow = narrow || (there & kNarrow) != 0;
        if ((here >> k & there >> (k + 2) % 4 & 1) == 0) *edges[k] = kUnreachableCost;
    }
    return narrow;
}

void GroundCostCrop::compute(const GroundRasters& ground, double radius, double openCost,
                             const CellRect& area, Cell shift, std::span<const ClosedGap> gaps,
                             std::span<const NarrowCell> narrow, UnitCost& cost) {
    findNodes(ground, radius, area);
    closeGaps(ground.grid, gaps);
    openNarrow(ground.grid, narrow);
    const GroundNodeFinder finder(ground, radius);
    const Grid& grid = ground.grid;
    const auto nodeAt = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) ? nodes_[grid.index({x, y})] : GroundNode{};
    };
    for (std::int32_t y = area.low.y; y <= area.high.y; ++y)
        for (std::int32_t x = area.low.x; x <= area.high.x; ++x) {
            const std::int32_t index = grid.index({x, y});
            const GroundNode& here = nodes_[index];
            if (!here.free) continue;
            const auto unit = static_cast<float>(openCost / ground.travelSpeed[index]);
            const std::int32_t to = cost.grid.index({x + shift.x, y + shift.y});
            CellCost& out = cost.cells[to];
            out = {unit, unit, unit, unit};
            if (finder.farFromWalls({x, y})) continue;  // Such a cell is far from gaps too.
            out = edgesOf(here, nodeAt(x + 1, y), nodeAt(x, y + 1), nodeAt(x - 1, y), nodeAt(x, y - 1), unit);
            if (closeEdges(grid, {x, y}, out) || !isOpen(out, unit))
                cost.nodes.push_back({to, here.x, here.y, here.normalX, here.normalY, unit});
        }
}

}  // namespace muster
