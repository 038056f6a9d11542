#include "engine/assignment/planning/exact/connected_regions.h"

#include "base/bilinear.h"
#include "base/grid_search.h"

namespace muster {

void ConnectedRegions::label(const UnitCost& cost) {
    constexpr std::int32_t kWall = -1;
    grid_ = cost.grid;
    labels_.resize(cost.cells.size());
    for (std::int32_t k = 0; k < grid_.count(); ++k) labels_[k] = cost.wall(k) ? kWall : kUnlabelled;
    count_ = labelRegions(grid_, labels_, stack_);
}

std::int32_t ConnectedRegions::at(Vec2 p) const {
    if (count_ == 0) return -1;
    const std::int32_t label = labels_[grid_.index(grid_.nearestCell(p))];
    return label >= 0 ? label : labels_[nearestFreeCell(p)];
}

Vec2 ConnectedRegions::nearestFreePoint(Vec2 p) const {
    if (count_ == 0) return p;
    for (const std::int32_t k : bilinearStencil(grid_, p).cell)
        if (labels_[k] >= 0) return p;
    return grid_.centre(grid_.at(nearestFreeCell(p)));
}

// Index of the free cell whose centre is nearest; there is one.
std::int32_t ConnectedRegions::nearestFreeCell(Vec2 p) const {
    const auto found = nearestCellWhere(grid_, p, [&](std::int32_t k) { return labels_[k] >= 0; });
    return found ? grid_.index(*found) : 0;
}

}  // namespace muster
