#include "engine/fields/eikonal/line_of_sight.h"

#include <algorithm>

namespace muster {
namespace {

// Depth to which a line may enter the forbidden zone at a wall, so that polylines can follow round obstacles
// [cells].
constexpr float kZonePenetration = 0.05f;

}  // namespace

void LineOfSight::begin(const UnitCost& cost) {
    cost_ = &cost;
    if (wall_.size() != cost.cells.size()) wall_.assign(cost.cells.size(), 0);
    std::int32_t number = 0;
    hasNarrow_ = false;
    for (const WallNode& node : cost.nodes) {
        wall_[node.cell] = ++number;
        hasNarrow_ = hasNarrow_ || node.narrow();
    }
}

void LineOfSight::end() {
    for (const WallNode& node : cost_->nodes) wall_[node.cell] = 0;
    cost_ = nullptr;
}

// The obstruction at one point, which is in `cell`; `nearWall` is false where the cell is open.
inline Visibility LineOfSight::sample(float px, float py, float unit, bool& nearWall,
                                      std::int32_t& cell) const {
    // A wall node of a cell at the edge may lie outside the grid, and so may the middle of an arc.
    const std::int32_t column = std::clamp(static_cast<std::int32_t>(px + 0.5f), 0, cost_->grid.width - 1);
    const std::int32_t row = std::clamp(static_cast<std::int32_t>(py + 0.5f), 0, cost_->grid.height - 1);
    cell = row * cost_->grid.width + column;
    if (open(cell, unit)) {
        nearWall = false;
        return Visibility::Clear;
    }
    nearWall = true;
    const std::int32_t number = wall_[cell];
    if (number == 0) return cost_->wall(cell) ? Visibility::Wall : Visibility::OtherGround;
    const WallNode& wallNode = node(number);
    if (wallNode.narrow()) return Visibility::Wall;
    if (wallNode.unit != unit) return Visibility::OtherGround;
    const float outX = px - static_cast<float>(column) - wallNode.x;
    const float outY = py - static_cast<float>(row) - wallNode.y;
    const float depth = outX * wallNode.normalX + outY * wallNode.normalY;
    return depth < -kZonePenetration ? Visibility::Wall : Visibility::Clear;
}

Visibility LineOfSight::trace(float x, float y, const PseudoSource& source, std::int32_t& stop) const {
    const float dx = source.x - x;
    const float dy = source.y - y;
    const auto steps = static_cast<std::int32_t>(std::ceil(std::max(std::fabs(dx), std::fabs(dy))));
    const float stepX = dx / static_cast<float>(steps);
    const float stepY = dy / static_cast<float>(steps);
    bool wasNearWall = true;
    for (std::int32_t k = 1; k <= steps; ++k) {
        const auto at = static_cast<float>(k);
        bool nearWall = true;
        if (k < steps) {
            const Visibility here = sample(x + stepX * at, y + stepY * at, source.unit, nearWall, stop);
            if (here != Visibility::Clear) return here;
        }
        // Near walls also halfway: one sample per cell would cut the rounded corners of obstacles.
        if (wasNearWall || nearWall) {
            bool ignored = false;
            const Visibility halfway = sample(x + stepX * (at - 0.5f), y + stepY * (at - 0.5f), source.unit,
                                              ignored, stop);
            if (halfway != Visibility::Clear) return halfway;
        }
        wasNearWall = nearWall;
    }
    return Visibility::Clear;
}

}  // namespace muster
