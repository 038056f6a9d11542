#include "eikonal/line_of_sight.h"

#include <algorithm>

namespace muster {
namespace {

// A way may dip this far into the forbidden zone beside a wall, so that polylines can follow round discs
// [cells].
constexpr float kDip = 0.05f;

}  // namespace

void LineOfSight::begin(const UnitCost& cost) {
    cost_ = &cost;
    if (wall_.size() != cost.cells.size()) wall_.assign(cost.cells.size(), 0);
    std::int32_t number = 0;
    for (const WallNode& node : cost.nodes) wall_[node.cell] = ++number;
}

void LineOfSight::end() {
    for (const WallNode& node : cost_->nodes) wall_[node.cell] = 0;
    cost_ = nullptr;
}

// What a way meets at one point of it, which lies in `cell`; `besideWall` tells whether walls are near.
inline Ray LineOfSight::meets(float px, float py, float unit, bool& besideWall, std::int32_t& cell) const {
    const auto column = static_cast<std::int32_t>(px + 0.5f);
    const auto row = static_cast<std::int32_t>(py + 0.5f);
    cell = row * cost_->grid.width + column;
    if (open(cell, unit)) {
        besideWall = false;
        return Ray::Clear;
    }
    besideWall = true;
    const std::int32_t number = wall_[cell];
    if (number == 0) return cost_->wall(cell) ? Ray::Wall : Ray::OtherGround;
    const WallNode& beside = node(number);
    if (beside.unit != unit) return Ray::OtherGround;
    const float outX = px - static_cast<float>(column) - beside.x;
    const float outY = py - static_cast<float>(row) - beside.y;
    return outX * beside.normalX + outY * beside.normalY < -kDip ? Ray::Wall : Ray::Clear;
}

Ray LineOfSight::look(float x, float y, const PseudoSource& root, std::int32_t& stop) const {
    const float dx = root.x - x;
    const float dy = root.y - y;
    const auto steps = static_cast<std::int32_t>(std::ceil(std::max(std::fabs(dx), std::fabs(dy))));
    const float stepX = dx / static_cast<float>(steps);
    const float stepY = dy / static_cast<float>(steps);
    bool before = true;
    for (std::int32_t k = 1; k <= steps; ++k) {
        const auto away = static_cast<float>(k);
        bool here = true;
        if (k < steps) {
            const Ray ray = meets(x + stepX * away, y + stepY * away, root.unit, here, stop);
            if (ray != Ray::Clear) return ray;
        }
        // Beside walls also halfway, as one look per cell would cut the rounded corners of obstacles.
        if (before || here) {
            bool ignored = false;
            const Ray ray = meets(x + stepX * (away - 0.5f), y + stepY * (away - 0.5f), root.unit, ignored,
                                  stop);
            if (ray != Ray::Clear) return ray;
        }
        before = here;
    }
    return Ray::Clear;
}

}  // namespace muster
