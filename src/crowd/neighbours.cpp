#include "muster/crowd/neighbours.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// More cells than this per character are not worth clearing.
constexpr double kCellsPerCharacter = 16.0;

Box boundsOfPositions(std::span<const Vec2> positions) {
    Box box{positions[0], positions[0]};
    for (Vec2 p : positions) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

}  // namespace

void NeighbourGrid::sortIntoCells(std::span<const Vec2> positions, double reach) {
    const Box box = boundsOfPositions(positions).grown(0.5 * reach);
    const double limit = kCellsPerCharacter * static_cast<double>(positions.size()) + 64.0;
    const double edge = std::max(reach, std::sqrt(box.width() * box.height() / limit));
    grid_ = Grid::covering(box, edge);
    cellStart_.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
    cellOf_.resize(positions.size());
    order_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        cellOf_[i] = grid_.index(grid_.nearestCell(positions[i]));
        ++cellStart_[static_cast<std::size_t>(cellOf_[i]) + 1];
    }
    for (std::size_t c = 1; c < cellStart_.size(); ++c) cellStart_[c] += cellStart_[c - 1];
    // Filling from the back leaves each cell's first index in place and its members ascending.
    for (std::size_t i = positions.size(); i-- > 0;)
        order_[static_cast<std::size_t>(--cellStart_[static_cast<std::size_t>(cellOf_[i]) + 1])] =
            static_cast<std::int32_t>(i);
    // Now cellStart_[c + 1] is the start of cell c; shift by one.
    for (std::size_t c = 0; c + 1 < cellStart_.size(); ++c) cellStart_[c] = cellStart_[c + 1];
    cellStart_.back() = static_cast<std::int32_t>(positions.size());
}

void NeighbourGrid::findPairs(std::span<const Vec2> positions, double reach, std::vector<NearPair>& pairs) {
    pairs.clear();
    if (positions.size() < 2) return;
    sortIntoCells(positions, reach);
    const double reach2 = reach * reach;
    const auto test = [&](std::int32_t i, std::int32_t j) {
        const Vec2 d = positions[static_cast<std::size_t>(j)] - positions[static_cast<std::size_t>(i)];
        if (lengthSquared(d) < reach2) pairs.push_back({std::min(i, j), std::max(i, j)});
    };
    // Half of the eight neighbouring cells suffices: each pair of cells is met once.
    constexpr Cell kForward[] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (std::int32_t c = 0; c < grid_.count(); ++c) {
        const std::int32_t begin = cellStart_[static_cast<std::size_t>(c)];
        const std::int32_t end = cellStart_[static_cast<std::size_t>(c) + 1];
        if (begin == end) continue;
        const Cell cell = grid_.at(c);
        for (std::int32_t u = begin; u < end; ++u)
            for (std::int32_t v = u + 1; v < end; ++v)
                test(order_[static_cast<std::size_t>(u)], order_[static_cast<std::size_t>(v)]);
        for (const Cell step : kForward) {
            const Cell other{cell.x + step.x, cell.y + step.y};
            if (!grid_.contains(other)) continue;
            const auto o = static_cast<std::size_t>(grid_.index(other));
            for (std::int32_t u = begin; u < end; ++u)
                for (std::int32_t v = cellStart_[o]; v < cellStart_[o + 1]; ++v)
                    test(order_[static_cast<std::size_t>(u)], order_[static_cast<std::size_t>(v)]);
        }
    }
}

}  // namespace muster
