#include "fields/ground_cost.h"

#include <algorithm>
#include <limits>

namespace muster {

float priceGround(const Environment& environment, double radius, double price, std::vector<CellCost>& cells) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const Grid& grid = environment.grid();
    const std::span<const float> clearance = environment.clearance();
    const std::span<const float> travelSpeed = environment.travelSpeed();
    const auto free = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) && clearance[grid.index({x, y})] >= static_cast<float>(radius);
    };
    cells.resize(static_cast<std::size_t>(grid.count()));
    float lowest = kInfinite;
    for (std::int32_t y = 0; y < grid.height; ++y) {
        for (std::int32_t x = 0; x < grid.width; ++x) {
            CellCost& out = cells[grid.index({x, y})];
            out = {kInfinite, kInfinite, kInfinite, kInfinite};
            if (!free(x, y)) continue;
            const auto unit = static_cast<float>(price / travelSpeed[grid.index({x, y})]);
            if (free(x + 1, y)) out.east = unit;
            if (free(x, y + 1)) out.north = unit;
            if (free(x - 1, y)) out.west = unit;
            if (free(x, y - 1)) out.south = unit;
            lowest = std::min(lowest, unit);
        }
    }
    return lowest < kInfinite ? lowest : static_cast<float>(price);
}

}  // namespace muster
