#include "muster/crowd/neighbours.h"

#include <algorithm>

namespace muster {

void NeighbourGrid::findPairs(std::span<const Vec2> positions, double reach, std::vector<NearPair>& pairs) {
    pairs.clear();
    if (positions.size() < 2) return;
    cells_.sort(positions, reach);
    const std::span<const std::int32_t> items = cells_.items();
    sorted_.resize(items.size());
    for (std::size_t k = 0; k < items.size(); ++k) sorted_[k] = positions[static_cast<std::size_t>(items[k])];
    const Grid& grid = cells_.grid();
    for (std::int32_t y = 0; y < grid.height; ++y) findInRow(y, reach * reach, pairs);
}

// Of each point's neighbours those that lie behind it in the order of cells: the rest of its cell and the one to the
// right, which follow each other in memory, and three cells of the row above, which do so too.
void NeighbourGrid::findInRow(std::int32_t y, double reach2, std::vector<NearPair>& pairs) {
    const Grid& grid = cells_.grid();
    const std::int32_t* items = cells_.items().data();
    const Vec2* points = sorted_.data();
    const auto test = [&](std::int32_t u, std::int32_t begin, std::int32_t end) {
        const Vec2 p = points[u];
        for (std::int32_t v = begin; v < end; ++v) {
            if (!(lengthSquared(points[v] - p) < reach2)) continue;
            pairs.push_back({std::min(items[u], items[v]), std::max(items[u], items[v])});
        }
    };
    const std::int32_t first = grid.index({0, y});
    for (std::int32_t x = 0; x < grid.width; ++x) {
        const std::int32_t begin = cells_.begin(first + x);
        const std::int32_t end = cells_.begin(first + x + 1);
        if (begin == end) continue;
        const std::int32_t beside = x + 1 < grid.width ? cells_.begin(first + x + 2) : end;
        std::int32_t above = 0, aboveEnd = 0;
        if (y + 1 < grid.height) {
            above = cells_.begin(first + grid.width + std::max(0, x - 1));
            aboveEnd = cells_.begin(first + grid.width + std::min(grid.width - 1, x + 1) + 1);
        }
        for (std::int32_t u = begin; u < end; ++u) {
            test(u, u + 1, beside);
            test(u, above, aboveEnd);
        }
    }
}

}  // namespace muster
