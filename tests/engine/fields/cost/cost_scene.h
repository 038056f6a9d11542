// Unit costs for tests, given by a function.
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>

#include "engine/fields/cost/unit_cost.h"

namespace muster::test {

inline constexpr float kInfinity = kUnreachableCost;

/// Bit by bit.
inline bool sameCost(const CellCost& a, const CellCost& b) {
    return std::memcmp(&a, &b, sizeof(CellCost)) == 0;
}

/// Unit costs by a function of the cell's centre; a cell is a wall where `east` is infinite.
inline UnitCost makeCost(const Box& box, double cell, const std::function<CellCost(Vec2)>& costAt) {
    UnitCost cost{.grid = Grid::covering(box, cell)};
    cost.cells.resize(cost.grid.count());
    cost.lowest = kInfinity;
    for (std::int32_t k = 0; k < cost.grid.count(); ++k)
        cost.cells[k] = costAt(cost.grid.centre(cost.grid.at(k)));
    const auto wall = [&](Cell c) {
        return !cost.grid.contains(c) || cost.cells[cost.grid.index(c)].east == kInfinity;
    };
    std::vector<CellCost> closed = cost.cells;
    for (std::int32_t k = 0; k < cost.grid.count(); ++k) {
        const Cell c = cost.grid.at(k);
        CellCost& out = closed[k];
        const CellCost open = cost.cells[k];
        if (wall(c)) {
            out = {kInfinity, kInfinity, kInfinity, kInfinity};
            continue;
        }
        if (wall({c.x + 1, c.y})) out.east = kInfinity;
        if (wall({c.x, c.y + 1})) out.north = kInfinity;
        if (wall({c.x - 1, c.y})) out.west = kInfinity;
        if (wall({c.x, c.y - 1})) out.south = kInfinity;
        cost.lowest = std::min({cost.lowest, open.east, open.north, open.west, open.south});
    }
    cost.cells = closed;
    return cost;
}

/// The same unit cost in all directions.
inline CellCost isotropic(double cost) {
    const auto c = static_cast<float>(cost);
    return {c, c, c, c};
}

}  // namespace muster::test
