#include "engine/fields/cost/ground_level.h"

#include <algorithm>
#include <limits>

namespace muster {

GroundLevel::GroundLevel(const StaticGround& ground, std::int32_t ratio)
    : ground_(&ground), ratio_(ratio), grid_(ground.grid()) {
    if (ratio == 2) grid_ = {grid_.origin, 2.0 * grid_.cell, (grid_.width + 1) / 2, (grid_.height + 1) / 2};
}

// Mean clearance of the four ground cells under a wider cell; at the edge of the ground some count twice.
float GroundLevel::meanClearance(Cell cell) const {
    const Grid& ground = ground_->grid();
    const std::span<const float> clearance = ground_->rawClearance();
    float mean = 0.0f;
    for (const std::int32_t y : {2 * cell.y, std::min(2 * cell.y + 1, ground.height - 1)})
        for (const std::int32_t x : {2 * cell.x, std::min(2 * cell.x + 1, ground.width - 1)})
            mean += 0.25f * clearance[ground.index({x, y})];
    return mean;
}

float GroundLevel::meanSpeed(Cell cell) const {
    const Grid& ground = ground_->grid();
    float slowness = 0.0f;
    for (const std::int32_t y : {2 * cell.y, std::min(2 * cell.y + 1, ground.height - 1)})
        for (const std::int32_t x : {2 * cell.x, std::min(2 * cell.x + 1, ground.width - 1)})
            slowness += 0.25f / ground_->travelSpeed(ground.index({x, y}));
    return 1.0f / slowness;
}

float GroundLevel::clearance(std::int32_t cell) const {
    if (ratio_ == 1) return ground_->clearance(cell);
    return meanClearance(grid_.at(cell)) - static_cast<float>(ground_->radius());
}

float GroundLevel::uniformClearance(std::int32_t cell) const {
    const Cell c = grid_.at(cell);
    return ground_->uniformClearanceOf({ratio_ * c.x, ratio_ * c.y});
}

std::int32_t GroundLevel::freeCellNear(Vec2 p) const {
    constexpr std::int32_t kReach = 2;
    const Cell middle = grid_.nearestCell(p);
    std::int32_t found = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int32_t y = middle.y - kReach; y <= middle.y + kReach; ++y)
        for (std::int32_t x = middle.x - kReach; x <= middle.x + kReach; ++x) {
            if (!grid_.contains({x, y}) || blocked(grid_.index({x, y}))) continue;
            const double d = lengthSquared(grid_.centre({x, y}) - p);
            if (d >= nearest) continue;
            nearest = d;
            found = grid_.index({x, y});
        }
    return found;
}

void GroundLevel::unitCost(const CellRect& area, Scratch& scratch, UnitCost& cost) const {
    const Vec2 shift{area.low.x * grid_.cell, area.low.y * grid_.cell};
    cost.grid = {grid_.origin + shift, grid_.cell, area.high.x - area.low.x + 1,
                 area.high.y - area.low.y + 1};
    cost.radius = ground_->radius();
    cost.lowest = lowestUnitCost();
    cost.cells.assign(cost.grid.count(),
                      {kUnreachableCost, kUnreachableCost, kUnreachableCost, kUnreachableCost});
    cost.nodes.clear();
    const CellRect whole{{0, 0}, {grid_.width - 1, grid_.height - 1}};
    const CellRect within = whole.common(area);
    if (within.empty()) return;
    const CellRect around = whole.common({{within.low.x - kGroundReach, within.low.y - kGroundReach},
                                          {within.high.x + kGroundReach, within.high.y + kGroundReach}});
    const Grid crop{grid_.origin + Vec2{around.low.x * grid_.cell, around.low.y * grid_.cell}, grid_.cell,
                    around.high.x - around.low.x + 1, around.high.y - around.low.y + 1};
    scratch.clearance.resize(crop.count());
    scratch.speed.resize(ground_->uniform() ? 0 : crop.count());
    for (std::int32_t y = 0; y < crop.height; ++y)
        for (std::int32_t x = 0; x < crop.width; ++x) {
            const Cell c{around.low.x + x, around.low.y + y};
            const std::int32_t to = crop.index({x, y});
            const std::int32_t from = grid_.index(c);
            scratch.clearance[to] = ratio_ == 1 ? ground_->rawClearance()[from] : meanClearance(c);
            if (!scratch.speed.empty())
                scratch.speed[to] = ratio_ == 1 ? ground_->travelSpeed(from) : meanSpeed(c);
        }
    scratch.gaps.clear();
    if (!ground_->gaps().empty()) ground_->gaps().within(crop.box(), scratch.gaps);
    findNarrow(around, crop, scratch.narrow);
    const float uniformSpeed = ground_->travelSpeed(0);
    const GroundRasters rasters{
        crop, scratch.clearance,
        scratch.speed.empty() ? RasterView(&uniformSpeed) : RasterView(scratch.speed)};
    const Cell low = around.low;
    scratch.crop.compute(
        rasters, cost.radius, ground_->openCost(),
        {{within.low.x - low.x, within.low.y - low.y}, {within.high.x - low.x, within.high.y - low.y}},
        {low.x - area.low.x, low.y - area.low.y}, scratch.gaps, scratch.narrow, cost);
}

// Finds the narrow cells of the ground that lie in a crop of it, numbered by the crop. Wider cells have none.
void GroundLevel::findNarrow(const CellRect& cells, const Grid& crop, std::vector<NarrowCell>& narrow) const {
    narrow.clear();
    if (ratio_ != 1) return;
    for (NarrowCell found : ground_->narrowWays().between(grid_.index(cells.low), grid_.index(cells.high))) {
        const Cell c = grid_.at(found.cell);
        if (c.x < cells.low.x || c.x > cells.high.x) continue;
        found.cell = crop.index({c.x - cells.low.x, c.y - cells.low.y});
        narrow.push_back(found);
    }
}

UnitCost GroundLevel::unitCost() const {
    UnitCost cost;
    Scratch scratch;
    unitCost({{0, 0}, {grid_.width - 1, grid_.height - 1}}, scratch, cost);
    return cost;
}

bool GroundLevel::changesSince(std::uint32_t version, std::vector<CellRect>& areas) const {
    const std::size_t first = areas.size();
    if (!ground_->changesSince(version, areas)) return false;
    for (std::size_t k = first; k < areas.size(); ++k) {
        const CellRect area = areas[k];
        areas[k] = {{area.low.x / ratio_ - kGroundReach, area.low.y / ratio_ - kGroundReach},
                    {area.high.x / ratio_ + kGroundReach, area.high.y / ratio_ + kGroundReach}};
    }
    return true;
}

}  // namespace muster
