#include "transport/ground_regions.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr std::int32_t kUnlabelled = -2;
constexpr std::int32_t kWall = -1;

}  // namespace

void GroundRegions::label(const UnitCost& cost) {
    grid_ = cost.grid;
    count_ = 0;
    labels_.resize(cost.cells.size());
    for (std::int32_t k = 0; k < grid_.count(); ++k) labels_[k] = cost.wall(k) ? kWall : kUnlabelled;
    for (std::int32_t k = 0; k < grid_.count(); ++k)
        if (labels_[k] == kUnlabelled) flood(k, count_++);
}

void GroundRegions::flood(std::int32_t start, std::int32_t label) {
    const auto take = [&](std::int32_t k) {
        if (labels_[k] != kUnlabelled) return;
        labels_[k] = label;
        stack_.push_back(k);
    };
    stack_.clear();
    take(start);
    while (!stack_.empty()) {
        const std::int32_t k = stack_.back();
        stack_.pop_back();
        const Cell c = grid_.at(k);
        if (c.x > 0) take(k - 1);
        if (c.x + 1 < grid_.width) take(k + 1);
        if (c.y > 0) take(k - grid_.width);
        if (c.y + 1 < grid_.height) take(k + grid_.width);
    }
}

std::int32_t GroundRegions::at(Vec2 p) const {
    if (count_ == 0) return -1;
    const Cell c = grid_.nearestCell(p);
    const std::int32_t label = labels_[grid_.index(c)];
    return label >= 0 ? label : nearestFree(p, c);
}

// Searches square rings until the next ring cannot be nearer.
std::int32_t GroundRegions::nearestFree(Vec2 p, Cell from) const {
    double best = std::numeric_limits<double>::infinity();
    std::int32_t label = -1;
    const std::int32_t most = std::max(grid_.width, grid_.height);
    for (std::int32_t r = 1; r <= most; ++r) {
        for (std::int32_t y = from.y - r; y <= from.y + r; ++y) {
            const bool edge = y == from.y - r || y == from.y + r;
            for (std::int32_t x = from.x - r; x <= from.x + r; x += edge ? 1 : 2 * r) {
                if (!grid_.contains({x, y}) || labels_[grid_.index({x, y})] < 0) continue;
                const double d = distance(p, grid_.centre({x, y}));
                if (d >= best) continue;
                best = d;
                label = labels_[grid_.index({x, y})];
            }
        }
        if (best <= (r + 0.5) * grid_.cell) break;
    }
    return label;
}

}  // namespace muster
