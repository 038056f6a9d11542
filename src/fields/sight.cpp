#include "fields/sight.h"

#include <algorithm>

namespace muster {
namespace {

// A way may dip this far into the forbidden zone beside a wall, so that polylines can follow round discs [cells].
constexpr float kDip = 0.05f;
// Looks per cell along a way: one per cell would cut the rounded corners of obstacles.
constexpr float kLooks = 2.0f;

}  // namespace

void Sight::begin(const UnitCost& cost) {
    cost_ = &cost;
    if (wall_.size() != cost.cells.size()) wall_.assign(cost.cells.size(), 0);
    std::int32_t number = 0;
    for (const WallNode& node : cost.nodes) wall_[node.cell] = ++number;
}

void Sight::end() {
    for (const WallNode& node : cost_->nodes) wall_[node.cell] = 0;
    cost_ = nullptr;
}

Ray Sight::look(float x, float y, const Root& root) const {
    const Grid& grid = cost_->grid;
    const float dx = root.x - x;
    const float dy = root.y - y;
    const auto steps = static_cast<std::int32_t>(std::ceil(kLooks * std::max(std::fabs(dx), std::fabs(dy))));
    const float stepX = dx / static_cast<float>(steps);
    const float stepY = dy / static_cast<float>(steps);
    for (std::int32_t k = 1; k < steps; ++k) {
        const float px = x + stepX * static_cast<float>(k);
        const float py = y + stepY * static_cast<float>(k);
        const auto column = static_cast<std::int32_t>(px + 0.5f);
        const auto row = static_cast<std::int32_t>(py + 0.5f);
        const std::int32_t cell = row * grid.width + column;
        const std::int32_t number = wall_[cell];
        if (number == 0) {
            const CellCost& c = cost_->cells[cell];
            if (c.east == root.unit && c.north == root.unit && c.west == root.unit && c.south == root.unit) continue;
            return cost_->wall(cell) ? Ray::Wall : Ray::OtherGround;
        }
        const WallNode& beside = node(number);
        if (beside.unit != root.unit) return Ray::OtherGround;
        const float outX = px - static_cast<float>(column) - beside.x;
        const float outY = py - static_cast<float>(row) - beside.y;
        if (outX * beside.normalX + outY * beside.normalY < -kDip) return Ray::Wall;
    }
    return Ray::Clear;
}

}  // namespace muster
