#include "environment/a_star.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace muster {
namespace {

constexpr double kDiagonal = 1.4142135623730951;

double octile(Cell a, Cell b) {
    const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
    return std::max(dx, dy) + (kDiagonal - 1.0) * std::min(dx, dy);
}

}  // namespace

void AStar::relax(std::int32_t cell, std::int32_t from, double cost, double heuristic) {
    if (seen_[cell] == run_ && cost_[cell] <= cost) return;
    seen_[cell] = run_;
    cost_[cell] = cost;
    parent_[cell] = from;
    open_.push_back({cost + heuristic, cell});
    std::push_heap(open_.begin(), open_.end(), ComesLater{});
}

void AStar::traceBack(std::int32_t start, std::int32_t goal) {
    path_.assign(1, goal);
    while (path_.back() != start) path_.push_back(parent_[path_.back()]);
    std::reverse(path_.begin(), path_.end());
}

std::span<const std::int32_t> AStar::run(const Grid& grid, std::span<const float> clearance, double radius,
                                         std::int32_t start, std::int32_t goal, std::int32_t maxCells) {
    const std::int32_t count = grid.count();
    if (std::cmp_not_equal(seen_.size(), count) || ++run_ == 0) {
        cost_.assign(count, 0.0);
        parent_.assign(count, -1);
        seen_.assign(count, 0);
        closed_.assign(count, 0);
        run_ = 1;
    }
    open_.clear();
    path_.clear();
    const Cell goalCell = grid.at(goal);
    const auto isFree = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) && clearance[grid.index({x, y})] >= radius;
    };
    relax(start, start, 0.0, octile(grid.at(start), goalCell));
    for (std::int32_t expanded = 0; !open_.empty() && expanded < maxCells;) {
        std::pop_heap(open_.begin(), open_.end(), ComesLater{});
        const std::int32_t at = open_.back().cell;
        open_.pop_back();
        if (closed_[at] == run_) continue;
        closed_[at] = run_;
        ++expanded;
        if (at == goal) {
            traceBack(start, goal);
            break;
        }
        const Cell c = grid.at(at);
        for (std::int32_t dy = -1; dy <= 1; ++dy) {
            for (std::int32_t dx = -1; dx <= 1; ++dx) {
                if ((dx == 0 && dy == 0) || !isFree(c.x + dx, c.y + dy)) continue;
                const bool diagonal = dx != 0 && dy != 0;
                if (diagonal && (!isFree(c.x + dx, c.y) || !isFree(c.x, c.y + dy))) continue;
                const Cell next{c.x + dx, c.y + dy};
                const std::int32_t index = grid.index(next);
                if (closed_[index] == run_) continue;
                relax(index, at, cost_[at] + (diagonal ? kDiagonal : 1.0), octile(next, goalCell));
            }
        }
    }
    return path_;
}

}  // namespace muster
