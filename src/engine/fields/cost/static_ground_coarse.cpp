// The coarse copy of the static ground. Its edges keep walls closed that are thinner than a coarse cell, and
// doors open that are one ground cell wide.
#include <algorithm>

#include "engine/fields/cost/static_ground.h"

namespace muster {

// The state of all cells within a coarse cell's edge of a ground cell, from its clearance: 1 where they are
// free, -1 where they are blocked, 0 where it is unknown.
int StaticGround::coarseState(Cell middle, std::int32_t ratio) const {
    if (!grid_.contains(middle)) return 0;
    const float here = clearance(grid_.index(middle));
    // No such cell's centre is farther away along the diagonal.
    const auto reach = static_cast<float>(1.5 * ratio * grid_.cell);
    return here > reach ? 1 : here < -reach ? -1 : 0;
}

// The cheapest straight row of ground cells from the centre of a coarse cell to the centre of the next;
// infinite where none is free.
float StaticGround::coarseEdge(Cell from, Cell step, std::int32_t ratio) const {
    float best = kUnreachableCost;
    const Cell to{from.x + step.x, from.y + step.y};
    if (!coarse_.grid.contains(to)) return best;
    const int state = coarseState({to.x * ratio, to.y * ratio}, ratio);
    if (state < 0) return best;
    if (state > 0 && uniform() && grid_.contains({to.x * ratio + ratio - 1, to.y * ratio + ratio - 1}))
        return lowest_;
    for (std::int32_t row = 0; row < ratio; ++row) {
        const auto cellAt = [&](std::int32_t k) {
            const std::int32_t along = ratio / 2 + k;
            return Cell{from.x * ratio + (step.x != 0 ? along : row),
                        from.y * ratio + (step.y != 0 ? along : row)};
        };
        float sum = 0.0f;
        bool uniform = true;
        float first = 0.0f;
        for (std::int32_t k = 0; k < ratio && sum < kUnreachableCost; ++k) {
            const Cell c = cellAt(k);
            if (!grid_.contains(c) || blocked(grid_.index(c))) {
                sum = kUnreachableCost;
                break;
            }
            const float unit = unitCostOf(grid_.index(c));
            if (k == 0) first = unit;
            uniform = uniform && unit == first;
            sum += unit;
        }
        if (crossesGap(grid_.centre(cellAt(0)), grid_.centre(cellAt(ratio)))) continue;
        // A mean of equal numbers may be off by rounding.
        if (sum < kUnreachableCost) best = std::min(best, uniform ? first : sum / static_cast<float>(ratio));
    }
    return best;
}

// The cheapest straight row of ground cells from the centre of the neighbour at `step` over the border into a
// coarse cell, by one ground cell; infinite where none is free.
float StaticGround::edgeToBorder(Cell cell, Cell step, std::int32_t ratio) const {
    float best = kUnreachableCost;
    if (!coarse_.grid.contains({cell.x + step.x, cell.y + step.y})) return best;
    const std::int32_t inside = step.x + step.y > 0 ? ratio - 1 : 0;
    for (std::int32_t row = 0; row < ratio; ++row) {
        const auto cellAt = [&](std::int32_t k) {
            return Cell{cell.x * ratio + (step.x != 0 ? inside + k * step.x : row),
                        cell.y * ratio + (step.y != 0 ? inside + k * step.y : row)};
        };
        float sum = 0.0f;
        const std::int32_t length = 1 + ratio / 2;
        for (std::int32_t k = 0; k < length && sum < kUnreachableCost; ++k) {
            const Cell c = cellAt(k);
            const bool free = grid_.contains(c) && !blocked(grid_.index(c));
            sum = free ? sum + unitCostOf(grid_.index(c)) : kUnreachableCost;
        }
        if (crossesGap(grid_.centre(cellAt(0)), grid_.centre(cellAt(length - 1)))) continue;
        if (sum < kUnreachableCost) best = std::min(best, sum / static_cast<float>(length));
    }
    return best;
}

// Finds coarse cells with a wall at the centre that can be entered from one side only. Where both opposite
// sides can be entered the wall may divide two regions, so that no value would be right for both.
void StaticGround::findPartiallyBlocked(const CellRect& cells, std::int32_t ratio) {
    const Grid& grid = coarse_.grid;
    std::erase_if(partiallyBlocked_, [&](const PartiallyBlockedCell& partial) {
        return !cells.common({partial.cell, partial.cell}).empty();
    });
    const auto kept = static_cast<std::ptrdiff_t>(partiallyBlocked_.size());
    for (std::int32_t y = cells.low.y; y <= cells.high.y; ++y)
        for (std::int32_t x = cells.low.x; x <= cells.high.x; ++x) {
            const Cell cell{x, y};
            const Cell centre{cell.x * ratio + ratio / 2, cell.y * ratio + ratio / 2};
            if (grid_.contains(centre) && !blocked(grid_.index(centre))) continue;
            if (coarseState(centre, ratio) < 0) continue;
            const CellCost& cost = coarse_.cells[grid.index(cell)];
            for (const bool alongX : {false, true}) {
                const Cell up = alongX ? Cell{1, 0} : Cell{0, 1};
                const Cell down{-up.x, -up.y};
                const float upperEdge = alongX ? cost.east : cost.north;
                const float lowerEdge = alongX ? cost.west : cost.south;
                if (upperEdge < kUnreachableCost || lowerEdge < kUnreachableCost) continue;
                const float above = edgeToBorder(cell, up, ratio);
                const float below = edgeToBorder(cell, down, ratio);
                if ((above < kUnreachableCost) == (below < kUnreachableCost)) continue;
                const Cell step = above < kUnreachableCost ? up : down;
                partiallyBlocked_.push_back({cell,
                                             {cell.x + step.x, cell.y + step.y},
                                             std::min(above, below) * static_cast<float>(grid.cell)});
            }
        }
    const auto comesFirst = [&](const PartiallyBlockedCell& a, const PartiallyBlockedCell& b) {
        return grid.index(a.cell) < grid.index(b.cell);
    };
    std::inplace_merge(partiallyBlocked_.begin(), partiallyBlocked_.begin() + kept, partiallyBlocked_.end(),
                       comesFirst);
}

std::span<const StaticGround::PartiallyBlockedCell> StaticGround::partiallyBlockedCellsIn(
    std::int32_t first, std::int32_t last) const {
    const auto from = std::partition_point(partiallyBlocked_.begin(), partiallyBlocked_.end(),
                                           [&](const auto& partial) { return partial.cell.y < first; });
    const auto to = std::partition_point(from, partiallyBlocked_.end(),
                                         [&](const auto& partial) { return partial.cell.y <= last; });
    return std::span(partiallyBlocked_).subspan(from - partiallyBlocked_.begin(), to - from);
}

void StaticGround::resetCoarse() {
    partiallyBlocked_.clear();
    std::int32_t ratio = 2;
    const auto across = [](std::int32_t cells, std::int32_t by) { return (cells + by - 1) / by; };
    while (across(grid_.width, ratio) * across(grid_.height, ratio) > kMaxCoarseCells &&
           2.0 * ratio * grid_.cell <= kMaxCoarseCell)
        ratio *= 2;
    coarse_.grid = {grid_.origin, grid_.cell * ratio, across(grid_.width, ratio),
                    across(grid_.height, ratio)};
    coarse_.radius = radius_;
    coarse_.nodes.clear();
    coarse_.cells.clear();
    if (coarse_.grid.cell > kMaxCoarseCell) return;
    coarse_.cells.assign(coarse_.grid.count(),
                         {kUnreachableCost, kUnreachableCost, kUnreachableCost, kUnreachableCost});
}

void StaticGround::updateCoarseEdges(const CellRect& cells, std::int32_t ratio) {
    const Grid& grid = coarse_.grid;
    // Edges are set from their western or southern cell.
    for (std::int32_t y = std::max(0, cells.low.y - 1); y <= cells.high.y; ++y)
        for (std::int32_t x = std::max(0, cells.low.x - 1); x <= cells.high.x; ++x) {
            const std::int32_t k = grid.index({x, y});
            const float east = coarseEdge({x, y}, {1, 0}, ratio);
            const float north = coarseEdge({x, y}, {0, 1}, ratio);
            coarse_.cells[k].east = east;
            coarse_.cells[k].north = north;
            if (x + 1 < grid.width) coarse_.cells[k + 1].west = east;
            if (y + 1 < grid.height) coarse_.cells[k + grid.width].south = north;
        }
}

// Updates the coarse cells that depend on the ground cells in `area`. An edge reads the ground of its two
// cells, a partially blocked cell that of its neighbours too.
void StaticGround::updateCoarse(const CellRect& area) {
    coarse_.lowest = lowest_;
    if (coarse_.cells.empty() || area.empty()) return;
    const Grid& grid = coarse_.grid;
    const auto ratio = static_cast<std::int32_t>(grid.cell / grid_.cell + 0.5);
    const CellRect whole{{0, 0}, {grid.width - 1, grid.height - 1}};
    const CellRect inside{{area.low.x / ratio, area.low.y / ratio},
                          {area.high.x / ratio, area.high.y / ratio}};
    updateCoarseEdges(inside, ratio);
    findPartiallyBlocked(
        whole.common({{inside.low.x - 1, inside.low.y - 1}, {inside.high.x + 1, inside.high.y + 1}}), ratio);
}

}  // namespace muster
