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
    const std::int32_t label = labels_[grid_.index(grid_.nearestCell(p))];
    return label >= 0 ? label : labels_[nearestFree(p)];
}

Vec2 GroundRegions::standing(Vec2 p) const {
    if (count_ == 0) return p;
    for (const std::int32_t k : grid_.bilinear(p).cell)
        if (labels_[k] >= 0) return p;
    return grid_.centre(grid_.at(nearestFree(p)));
}

// Index of the free cell whose centre is nearest. Searches square rings until the next ring cannot be nearer.
std::int32_t GroundRegions::nearestFree(Vec2 p) const {
    const Cell from = grid_.nearestCell(p);
    double best = std::numeric_limits<double>::infinity();
    std::int32_t found = 0;
    const std::int32_t most = std::max(grid_.width, grid_.height);
    for (std::int32_t r = 0; r <= most && best > (r - 0.5) * grid_.cell; ++r) {
        for (std::int32_t y = from.y - r; y <= from.y + r; ++y) {
            const bool edge = y == from.y - r || y == from.y + r;
            for (std::int32_t x = from.x - r; x <= from.x + r; x += edge ? 1 : 2 * r) {
                if (!grid_.contains({x, y}) || labels_[grid_.index({x, y})] < 0) continue;
                const double d = distance(p, grid_.centre({x, y}));
                if (d >= best) continue;
                best = d;
                found = grid_.index({x, y});
            }
        }
    }
    return found;
}

}  // namespace muster
