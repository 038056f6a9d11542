// The coarse copy of the static ground. Its edges keep walls closed that are thinner than a coarse cell, and
// doors open that are one ground cell wide.
#include <algorithm>

#include "cost/static_ground.h"

namespace muster {

// The cheapest straight row of ground cells from the centre of a coarse cell to the centre of the next;
// infinite where none is free.
float StaticGround::coarseEdge(Cell from, Cell step, std::int32_t ratio) const {
    float best = kUnreachableCost;
    const Cell to{from.x + step.x, from.y + step.y};
    if (!coarse_.grid.contains(to)) return best;
    for (std::int32_t row = 0; row < ratio; ++row) {
        float sum = 0.0f;
        bool uniform = true;
        float first = 0.0f;
        for (std::int32_t k = 0; k < ratio && sum < kUnreachableCost; ++k) {
            const std::int32_t along = ratio / 2 + k;
            const Cell c{from.x * ratio + (step.x != 0 ? along : row),
                         from.y * ratio + (step.y != 0 ? along : row)};
            if (!grid_.contains(c) || fine_.blocked(grid_.index(c))) {
                sum = kUnreachableCost;
                break;
            }
            const float unit = unit_[grid_.index(c)];
            if (k == 0) first = unit;
            uniform = uniform && unit == first;
            sum += unit;
        }
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
        float sum = 0.0f;
        const std::int32_t length = 1 + ratio / 2;
        for (std::int32_t k = 0; k < length && sum < kUnreachableCost; ++k) {
            const Cell c{cell.x * ratio + (step.x != 0 ? inside + k * step.x : row),
                         cell.y * ratio + (step.y != 0 ? inside + k * step.y : row)};
            const bool free = grid_.contains(c) && !fine_.blocked(grid_.index(c));
            sum = free ? sum + unit_[grid_.index(c)] : kUnreachableCost;
        }
        if (sum < kUnreachableCost) best = std::min(best, sum / static_cast<float>(length));
    }
    return best;
}

// Finds coarse cells with a wall at the centre that can be entered from one side only. Where both opposite
// sides can be entered the wall may divide two regions, so that no value would be right for both.
void StaticGround::findPartiallyBlocked(std::int32_t ratio) {
    const Grid& grid = coarse_.grid;
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Cell cell = grid.at(k);
        const Cell centre{cell.x * ratio + ratio / 2, cell.y * ratio + ratio / 2};
        if (grid_.contains(centre) && !fine_.blocked(grid_.index(centre))) continue;
        const CellCost& cost = coarse_.cells[k];
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
}

void StaticGround::computeCoarse() {
    partiallyBlocked_.clear();
    std::int32_t ratio = 2;
    const auto across = [](std::int32_t cells, std::int32_t by) { return (cells + by - 1) / by; };
    while (across(grid_.width, ratio) * across(grid_.height, ratio) > kMaxCoarseCells) ratio *= 2;
    coarse_.grid = {grid_.origin, grid_.cell * ratio, across(grid_.width, ratio),
                    across(grid_.height, ratio)};
    coarse_.radius = radius_;
    coarse_.lowest = fine_.cost.lowest;
    if (open_) return;  // No query reads it on open ground.
    const Grid& grid = coarse_.grid;
    coarse_.cells.assign(grid.count(),
                         {kUnreachableCost, kUnreachableCost, kUnreachableCost, kUnreachableCost});
    coarse_.nodes.clear();
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Cell c = grid.at(k);
        const float east = coarseEdge(c, {1, 0}, ratio);
        const float north = coarseEdge(c, {0, 1}, ratio);
        coarse_.cells[k].east = east;
        coarse_.cells[k].north = north;
        if (c.x + 1 < grid.width) coarse_.cells[k + 1].west = east;
        if (c.y + 1 < grid.height) coarse_.cells[k + grid.width].south = north;
    }
    findPartiallyBlocked(ratio);
}

}  // namespace muster
