#include "engine/fields/cost/unit_cost_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/fields/cost/crowd_speed.h"
#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/ground_cost.h"
#include "muster/assert.h"

namespace muster {
namespace {

// First and last of `count` cells in a row or column whose centres lie in [low, high), which are coordinates
// in cells from the origin.
void centresWithin(double low, double high, std::int32_t count, std::int32_t& first, std::int32_t& last) {
    first = static_cast<std::int32_t>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(count)));
    last = static_cast<std::int32_t>(std::clamp(std::ceil(high - 0.5), 0.0, static_cast<double>(count))) - 1;
}

}  // namespace

void UnitCostBuilder::update(const Parameters& parameters, const Environment& environment,
                             const DensityField& density, double radius) {
    const Parameters::Cost& def = parameters.cost;
    MUSTER_ASSERT(def.alpha >= 0.0 && def.beta >= 0.0 && def.alpha + def.beta > 0.0 && def.gamma >= 0.0);
    MUSTER_ASSERT(parameters.density.max > parameters.density.min && def.minSpeed > 0.0);
    MUSTER_ASSERT(parameters.character.maxSpeed > 0.0);
    restoreGround();
    updateGround(def, environment, radius);
    updateDiscomfort(parameters.discomfort, environment);
    addDynamicCost(parameters, environment, density);
}

void UnitCostBuilder::build(const Parameters& parameters, const Environment& environment,
                            const DensityField& density, double radius, UnitCost& cost) {
    update(parameters, environment, density, radius);
    cost = cost_;
}

// Undoes the last call's addDynamicCost().
void UnitCostBuilder::restoreGround() {
    for (const std::int32_t cell : dynamicCells_) cost_.cells[cell] = ground_[cell];
    for (const ClearedNode& cleared : clearedNodes_) cost_.nodes[cleared.node].unit = cleared.unit;
    dynamicCells_.clear();
    clearedNodes_.clear();
}

void UnitCostBuilder::updateGround(const Parameters::Cost& def, const Environment& environment,
                                   double radius) {
    const double openCost = def.alpha + def.beta;
    const bool all = !(environment.grid() == cost_.grid) || ground_.empty() || radius != cost_.radius ||
                     openCost != openCost_;
    changes_.clear();
    // Reading the clearance also brings the environment's version up to date.
    const std::span<const float> clearance = environment.clearance();
    if (!all && environment.instance() == instance_ && environment.groundVersion() == environmentVersion_)
        return;
    cost_.radius = radius;
    openCost_ = openCost;
    if (all) {
        cost_.grid = environment.grid();
        clearance_.assign(clearance.begin(), clearance.end());
        computeAll(environment);
    } else {
        findChanges(environment);
        if (!changes_.empty()) computeChanges();
    }
    instance_ = environment.instance();
    environmentVersion_ = environment.groundVersion();
}

void UnitCostBuilder::computeAll(const Environment& environment) {
    const RasterView travelSpeed = environment.travelSpeed();
    const std::int32_t count = cost_.grid.count();
    travelSpeed_.resize(count);
    for (std::int32_t k = 0; k < count; ++k) travelSpeed_[k] = travelSpeed[k];
    ground_.resize(count);
    unit_.resize(count);
    changed_.assign(count, 0);
    discomfort_.assign(count, 0.0f);
    discomfortCells_.clear();
    cost_.nodes.clear();
    computeGroundCost({cost_.grid, clearance_, travelSpeed_}, cost_.radius, openCost_, 0, count,
                      {ground_, unit_, cost_.nodes});
    cost_.cells = ground_;
    changes_.resize(count);
    std::iota(changes_.begin(), changes_.end(), 0);
    findLowest();
}

void UnitCostBuilder::findLowest() {
    float lowest = kUnreachableCost;
    for (const float unit : unit_) lowest = std::min(lowest, unit);
    const bool any = lowest < kUnreachableCost;
    cost_.lowest = any ? lowest : static_cast<float>(openCost_);
    lowestCount_ = any ? static_cast<std::int32_t>(std::count(unit_.begin(), unit_.end(), lowest)) : 0;
}

void UnitCostBuilder::findChanges(const Environment& environment) {
    areas_.clear();
    const bool known = environment.instance() == instance_ &&
                       environment.changesSince(environmentVersion_, areas_);
    if (!known) areas_.assign(1, {{0, 0}, {cost_.grid.width - 1, cost_.grid.height - 1}});
    for (const CellRect& area : areas_) compareRasters(environment, area);
    std::sort(changes_.begin(), changes_.end());
    for (const std::int32_t cell : changes_) changed_[cell] = 0;
}

// Takes over clearance and travel speed in `area` and notes the cells whose cost depends on a changed one.
// Clearances are compared only as far as they can matter, within kGroundBand of the radius.
void UnitCostBuilder::compareRasters(const Environment& environment, const CellRect& area) {
    const Grid& grid = cost_.grid;
    const std::span<const float> clearance = environment.clearance();
    const RasterView travelSpeed = environment.travelSpeed();
    const auto least = static_cast<float>(cost_.radius - kGroundBand * grid.cell);
    const auto most = static_cast<float>(cost_.radius + kGroundBand * grid.cell);
    for (std::int32_t y = area.low.y; y <= area.high.y; ++y) {
        for (std::int32_t x = area.low.x; x <= area.high.x; ++x) {
            const std::int32_t index = grid.index({x, y});
            const bool moved = std::clamp(clearance_[index], least, most) !=
                               std::clamp(clearance[index], least, most);
            const bool same = !moved && travelSpeed_[index] == travelSpeed[index];
            clearance_[index] = clearance[index];
            travelSpeed_[index] = travelSpeed[index];
            if (!same) noteChange({x, y});
        }
    }
}

void UnitCostBuilder::noteChange(Cell cell) {
    const Grid& grid = cost_.grid;
    const CellRect whole{{0, 0}, {grid.width - 1, grid.height - 1}};
    const CellRect around = whole.common(
        {{cell.x - kGroundReach, cell.y - kGroundReach}, {cell.x + kGroundReach, cell.y + kGroundReach}});
    for (std::int32_t y = around.low.y; y <= around.high.y; ++y) {
        for (std::int32_t x = around.low.x; x <= around.high.x; ++x) {
            std::uint8_t& mark = changed_[grid.index({x, y})];
            if (mark == 0) changes_.push_back(grid.index({x, y}));
            mark = 1;
        }
    }
}

void UnitCostBuilder::computeChanges() {
    for (const std::int32_t cell : changes_) lowestCount_ -= unit_[cell] == cost_.lowest ? 1 : 0;
    newNodes_.clear();
    computeGroundCost({cost_.grid, clearance_, travelSpeed_}, cost_.radius, openCost_, changes_,
                      {ground_, unit_, newNodes_});
    for (const std::int32_t cell : changes_) {
        cost_.cells[cell] = ground_[cell];
        if (unit_[cell] < cost_.lowest) lowestCount_ = 0;
        cost_.lowest = std::min(cost_.lowest, unit_[cell]);
        lowestCount_ += unit_[cell] == cost_.lowest ? 1 : 0;
    }
    if (lowestCount_ <= 0) findLowest();
    mergeNodes();
}

// Replaces the nodes of changed cells by the new ones; both lists ascend by cell.
void UnitCostBuilder::mergeNodes() {
    mergedNodes_.clear();
    auto added = newNodes_.begin();
    auto change = changes_.begin();
    for (const WallNode& node : cost_.nodes) {
        while (change != changes_.end() && *change < node.cell) ++change;
        while (added != newNodes_.end() && added->cell <= node.cell) mergedNodes_.push_back(*added++);
        const bool replaced = change != changes_.end() && *change == node.cell;
        if (!replaced) mergedNodes_.push_back(node);
    }
    mergedNodes_.insert(mergedNodes_.end(), added, newNodes_.end());
    cost_.nodes.swap(mergedNodes_);
}

void UnitCostBuilder::updateDiscomfort(const Parameters::Discomfort& def, const Environment& environment) {
    for (const std::int32_t cell : discomfortCells_) discomfort_[cell] = 0.0f;
    discomfortCells_.clear();
    if (!def.enabled) return;
    for (const ObstaclePiece& piece : environment.pieces())
        if (piece.moving) addDiscomfort(def, piece, cost_.grid, discomfort_, discomfortCells_);
}

// Finds the density cells from whose ground a density above `density.min` can be read.
void UnitCostBuilder::findCrowd(const Parameters::Density& def, const DensityField& density) {
    const Grid& grid = density.grid();
    if (crowdCells_.capacity() != density.density().size()) crowdCells_.reset(density.density().size());
    crowdCells_.clear();
    const auto reach = static_cast<std::int32_t>(std::ceil(1.0 + def.lookAhead / grid.cell));
    for (const std::int32_t cell : density.occupied()) {
        if (!(density.density()[cell] > def.min)) continue;
        const Cell c = grid.at(cell);
        for (std::int32_t y = std::max(0, c.y - reach); y <= std::min(grid.height - 1, c.y + reach); ++y) {
            for (std::int32_t x = std::max(0, c.x - reach); x <= std::min(grid.width - 1, c.x + reach); ++x)
                crowdCells_.insert(grid.index({x, y}));
        }
    }
}

void UnitCostBuilder::addDynamicCost(const Parameters& parameters, const Environment& environment,
                                     const DensityField& density) {
    const bool dense = parameters.density.enabled && !density.density().empty();
    if (dense) {
        findCrowd(parameters.density, density);
        for (const std::int32_t cell : crowdCells_.members())
            updateGroundWithin(parameters, environment, density, cell);
    }
    if (parameters.cost.gamma == 0.0) return;
    // Cells with discomfort that the crowd does not reach.
    const Grid& grid = cost_.grid;
    const RasterView travelSpeed = environment.travelSpeed();
    for (const std::int32_t index : discomfortCells_) {
        const Vec2 centre = grid.centre(grid.at(index));
        if (dense && crowdCells_.contains(density.grid().index(density.grid().nearestCell(centre)))) continue;
        updateCell(parameters, density, index, travelSpeed[index]);
    }
}

// Updates the ground cells whose centres lie in a density cell.
void UnitCostBuilder::updateGroundWithin(const Parameters& parameters, const Environment& environment,
                                         const DensityField& density, std::int32_t densityCell) {
    const RasterView travelSpeed = environment.travelSpeed();
    const Grid& grid = cost_.grid;
    const Grid& coarse = density.grid();
    const double ratio = coarse.cell / grid.cell;
    const Vec2 shift = (coarse.origin - grid.origin) / grid.cell;
    const Cell c = coarse.at(densityCell);
    CellRect within;
    centresWithin(shift.x + c.x * ratio, shift.x + (c.x + 1) * ratio, grid.width, within.low.x,
                  within.high.x);
    centresWithin(shift.y + c.y * ratio, shift.y + (c.y + 1) * ratio, grid.height, within.low.y,
                  within.high.y);
    for (std::int32_t y = within.low.y; y <= within.high.y; ++y) {
        for (std::int32_t x = within.low.x; x <= within.high.x; ++x) {
            const std::int32_t index = grid.index({x, y});
            updateCell(parameters, density, index, travelSpeed[index]);
        }
    }
}

void UnitCostBuilder::updateCell(const Parameters& parameters, const DensityField& density,
                                 std::int32_t index, double travelSpeed) {
    const CellCost& ground = ground_[index];
    const Vec2 centre = cost_.grid.centre(cost_.grid.at(index));
    const Parameters::Cost& def = parameters.cost;
    const double discomfort = def.gamma * discomfort_[index];
    const bool dense = parameters.density.enabled && !density.density().empty();
    const auto unitCost = [&](float groundCost, Vec2 direction) {
        const double f = dense ? relativeCrowdSpeed(parameters, density, centre, direction, travelSpeed)
                               : 1.0;
        // The ground cost holds (alpha + beta) / T.
        return static_cast<float>(groundCost * ((def.alpha * f + def.beta + discomfort) / (f * openCost_)));
    };
    const CellCost out{unitCost(ground.east, {1.0, 0.0}), unitCost(ground.north, {0.0, 1.0}),
                       unitCost(ground.west, {-1.0, 0.0}), unitCost(ground.south, {0.0, -1.0})};
    // Equal bits are meant. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    if (std::memcmp(&out, &ground, sizeof(CellCost)) == 0) return;
    cost_.cells[index] = out;
    dynamicCells_.push_back(index);
    const auto node = std::lower_bound(cost_.nodes.begin(), cost_.nodes.end(), index,
                                       [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    if (node == cost_.nodes.end() || node->cell != index) return;
    clearedNodes_.push_back({static_cast<std::int32_t>(node - cost_.nodes.begin()), node->unit});
    node->unit = 0.0f;
}

}  // namespace muster
