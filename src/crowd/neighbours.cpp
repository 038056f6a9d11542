#include "muster/crowd/neighbours.h"

#include <algorithm>

namespace muster {

void NeighbourGrid::findPairs(std::span<const Vec2> positions, double reach, std::vector<NearPair>& pairs) {
    pairs.clear();
    if (positions.size() < 2) return;
    cells_.sort(positions, reach);
    const Grid& grid = cells_.grid();
    const double reach2 = reach * reach;
    const auto test = [&](std::int32_t i, std::int32_t j) {
        const Vec2 d = positions[static_cast<std::size_t>(j)] - positions[static_cast<std::size_t>(i)];
        if (lengthSquared(d) < reach2) pairs.push_back({std::min(i, j), std::max(i, j)});
    };
    // Half of the eight neighbouring cells suffices: each pair of cells is met once.
    constexpr Cell kForward[] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (std::int32_t c = 0; c < grid.count(); ++c) {
        const std::span<const std::int32_t> here = cells_.within(c, c);
        if (here.empty()) continue;
        const Cell cell = grid.at(c);
        for (std::size_t u = 0; u < here.size(); ++u)
            for (std::size_t v = u + 1; v < here.size(); ++v) test(here[u], here[v]);
        for (const Cell step : kForward) {
            const Cell other{cell.x + step.x, cell.y + step.y};
            if (!grid.contains(other)) continue;
            const std::span<const std::int32_t> there = cells_.within(grid.index(other), grid.index(other));
            for (const std::int32_t i : here)
                for (const std::int32_t j : there) test(i, j);
        }
    }
}

}  // namespace muster
