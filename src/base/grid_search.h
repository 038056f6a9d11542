// Searches on grids: the nearest cell with a property, connected-component labelling.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// The cell whose centre is nearest to `p` among the cells for which `accept(index)` is true; of several
/// equally near cells the one of the lowest index. Searches square rings round `p` until no nearer cell is
/// possible.
template <class Accept>
std::optional<Cell> nearestCellWhere(const Grid& grid, Vec2 p, const Accept& accept) {
    const Cell start = grid.nearestCell(p);
    const std::int32_t rings = std::max(std::max(start.x, grid.width - 1 - start.x),
                                        std::max(start.y, grid.height - 1 - start.y));
    double bestSquared = std::numeric_limits<double>::infinity();
    std::int32_t best = -1;
    const auto test = [&](std::int32_t x, std::int32_t y) {
        if (!grid.contains({x, y})) return;
        const std::int32_t index = grid.index({x, y});
        if (!accept(index)) return;
        const double squared = lengthSquared(grid.centre({x, y}) - p);
        if (squared < bestSquared || (squared == bestSquared && index < best)) {
            bestSquared = squared;
            best = index;
        }
    };
    for (std::int32_t k = 0; k <= rings; ++k) {
        const double bound = (k - 0.5) * grid.cell * (1.0 - 1e-9);
        if (k > 0 && bound * bound > bestSquared) break;
        const std::int32_t left = std::max(start.x - k, 0), right = std::min(start.x + k, grid.width - 1);
        for (std::int32_t x = left; x <= right; ++x) {
            test(x, start.y - k);
            if (k > 0) test(x, start.y + k);
        }
        const std::int32_t low = std::max(start.y - k + 1, 0),
                           high = std::min(start.y + k - 1, grid.height - 1);
        for (std::int32_t y = low; y <= high; ++y) {
            test(start.x - k, y);
            test(start.x + k, y);
        }
    }
    if (best < 0) return {};
    return grid.at(best);
}

/// The label of cells that labelRegions() has to label.
inline constexpr std::int32_t kUnlabelled = -2;

/// Labels the 4-connected components of a grid, from 0 in row-major order of their first cells, by flood
/// fill. `labels` holds kUnlabelled for the cells to label and another negative number for all others, which
/// stay. Returns the number of components; `stack` is working memory.
inline std::int32_t labelRegions(const Grid& grid, std::span<std::int32_t> labels,
                                 std::vector<std::int32_t>& stack) {
    std::int32_t count = 0;
    const auto visit = [&](std::int32_t k) {
        if (labels[k] != kUnlabelled) return;
        labels[k] = count;
        stack.push_back(k);
    };
    for (std::int32_t first = 0; first < grid.count(); ++first) {
        if (labels[first] != kUnlabelled) continue;
        stack.clear();
        visit(first);
        while (!stack.empty()) {
            const std::int32_t k = stack.back();
            stack.pop_back();
            const Cell c = grid.at(k);
            if (c.x > 0) visit(k - 1);
            if (c.x + 1 < grid.width) visit(k + 1);
            if (c.y > 0) visit(k - grid.width);
            if (c.y + 1 < grid.height) visit(k + grid.width);
        }
        ++count;
    }
    return count;
}

}  // namespace muster
