#include "cost/unit_cost.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "cost/discomfort.h"
#include "cost/ground_cost.h"
#include "muster/assert.h"

namespace muster {
namespace {

// Speed in direction `along`, relative to the free speed of this ground (SPEC A4).
double relativeSpeed(const UnitCostDef& def, const DensityField& density, Vec2 p, Vec2 along,
                     double travelSpeed) {
    const double crowd = density.densityAt(p);
    if (crowd <= def.densityMin) return 1.0;
    const double flow = std::max(0.0, dot(density.velocityAt(p), along)) / (def.freeSpeed * travelSpeed);
    const double share = std::min(1.0, (crowd - def.densityMin) / (def.densityMax - def.densityMin));
    const double speed = 1.0 + share * (std::min(1.0, flow) - 1.0);
    return std::max(def.minSpeed, speed);
}

// First and last cell of a row or column of `count` cells whose centres lie in [low, high), in cells from the
// origin.
void centresWithin(double low, double high, std::int32_t count, std::int32_t& first, std::int32_t& last) {
    first = static_cast<std::int32_t>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(count)));
    last = static_cast<std::int32_t>(std::clamp(std::ceil(high - 0.5), 0.0, static_cast<double>(count))) - 1;
}

}  // namespace

void UnitCostBuilder::update(const UnitCostDef& def, const Environment& environment,
                             const DensityField& density, double radius) {
    MUSTER_ASSERT(def.alpha >= 0.0 && def.beta >= 0.0 && def.alpha + def.beta > 0.0 && def.gamma >= 0.0);
    MUSTER_ASSERT(def.freeSpeed > 0.0 && def.densityMax > def.densityMin && def.minSpeed > 0.0);
    restoreGround();
    updateGround(def, environment, radius);
    updateDiscomfort(def, environment);
    priceCrowd(def, environment, density);
}

void UnitCostBuilder::build(const UnitCostDef& def, const Environment& environment,
                            const DensityField& density, double radius, UnitCost& cost) {
    update(def, environment, density, radius);
    cost = cost_;
}

// Takes crowd and discomfort off again.
void UnitCostBuilder::restoreGround() {
    for (const std::int32_t cell : priced_) cost_.cells[cell] = ground_[cell];
    for (const HiddenNode& hidden : hiddenNodes_) cost_.nodes[hidden.node].unit = hidden.unit;
    priced_.clear();
    hiddenNodes_.clear();
}

// Prices anew those cells of the empty ground round which something changed.
void UnitCostBuilder::updateGround(const UnitCostDef& def, const Environment& environment, double radius) {
    const double price = def.alpha + def.beta;
    const bool anew = !(environment.grid() == cost_.grid) || ground_.empty() || radius != cost_.radius ||
                      price != price_;
    changes_.clear();
    // Brings the version up to date as well.
    const std::span<const float> clearance = environment.clearance();
    if (!anew && environment.instance() == instance_ && environment.groundVersion() == environmentVersion_)
        return;
    cost_.radius = radius;
    price_ = price;
    if (anew) {
        cost_.grid = environment.grid();
        clearance_.assign(clearance.begin(), clearance.end());
        priceAll(environment);
    } else {
        findChanges(environment);
        if (!changes_.empty()) priceChanges();
    }
    instance_ = environment.instance();
    environmentVersion_ = environment.groundVersion();
    if (!changes_.empty()) ++groundVersion_;
}

void UnitCostBuilder::priceAll(const Environment& environment) {
    const std::span<const float> travelSpeed = environment.travelSpeed();
    const auto count = static_cast<std::size_t>(cost_.grid.count());
    travelSpeed_.assign(travelSpeed.begin(), travelSpeed.end());
    ground_.resize(count);
    unit_.resize(count);
    changed_.assign(count, 0);
    discomfort_.assign(count, 0.0f);
    uneasy_.clear();
    cost_.nodes.clear();
    priceGround({cost_.grid, clearance_, travelSpeed_}, cost_.radius, price_, 0, cost_.grid.count(),
                {ground_, unit_, cost_.nodes});
    cost_.cells = ground_;
    changes_.resize(count);
    std::iota(changes_.begin(), changes_.end(), 0);
    findLowest();
}

// What a metre costs at least, and in how many cells.
void UnitCostBuilder::findLowest() {
    float lowest = std::numeric_limits<float>::infinity();
    for (const float unit : unit_) lowest = std::min(lowest, unit);
    const bool any = lowest < std::numeric_limits<float>::infinity();
    cost_.lowest = any ? lowest : static_cast<float>(price_);
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

// Lists the cells that another clearance or travel speed in `area` prices anew, and takes over both.
void UnitCostBuilder::compareRasters(const Environment& environment, const CellRect& area) {
    const Grid& grid = cost_.grid;
    const std::span<const float> clearance = environment.clearance();
    const std::span<const float> travelSpeed = environment.travelSpeed();
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
            if (same) continue;
            const CellRect whole{{0, 0}, {grid.width - 1, grid.height - 1}};
            const CellRect round = whole.common(
                {{x - kGroundReach, y - kGroundReach}, {x + kGroundReach, y + kGroundReach}});
            for (std::int32_t v = round.low.y; v <= round.high.y; ++v) {
                for (std::int32_t u = round.low.x; u <= round.high.x; ++u) {
                    std::uint8_t& mark = changed_[grid.index({u, v})];
                    if (mark == 0) changes_.push_back(grid.index({u, v}));
                    mark = 1;
                }
            }
        }
    }
}

void UnitCostBuilder::priceChanges() {
    for (const std::int32_t cell : changes_) lowestCount_ -= unit_[cell] == cost_.lowest ? 1 : 0;
    freshNodes_.clear();
    priceGround({cost_.grid, clearance_, travelSpeed_}, cost_.radius, price_, changes_,
                {ground_, unit_, freshNodes_});
    for (const std::int32_t cell : changes_) {
        cost_.cells[cell] = ground_[cell];
        if (unit_[cell] < cost_.lowest) lowestCount_ = 0;
        cost_.lowest = std::min(cost_.lowest, unit_[cell]);
        lowestCount_ += unit_[cell] == cost_.lowest ? 1 : 0;
    }
    if (lowestCount_ <= 0) findLowest();
    mergeNodes();
}

// Replaces the nodes of the cells priced anew by the fresh ones.
void UnitCostBuilder::mergeNodes() {
    mergedNodes_.clear();
    auto fresh = freshNodes_.begin();
    auto change = changes_.begin();
    for (const WallNode& node : cost_.nodes) {
        while (change != changes_.end() && *change < node.cell) ++change;
        while (fresh != freshNodes_.end() && fresh->cell <= node.cell) mergedNodes_.push_back(*fresh++);
        const bool replaced = change != changes_.end() && *change == node.cell;
        if (!replaced) mergedNodes_.push_back(node);
    }
    mergedNodes_.insert(mergedNodes_.end(), fresh, freshNodes_.end());
    cost_.nodes.swap(mergedNodes_);
}

void UnitCostBuilder::updateDiscomfort(const UnitCostDef& def, const Environment& environment) {
    for (const std::int32_t cell : uneasy_) discomfort_[cell] = 0.0f;
    uneasy_.clear();
    if (!def.discomfort) return;
    for (const ObstaclePiece& piece : environment.pieces())
        if (piece.moving) addDiscomfort(def, piece, cost_.grid, discomfort_, uneasy_);
}

// Marks the density cells from whose ground a crowd above densityMin can be read.
void UnitCostBuilder::markCrowded(const UnitCostDef& def, const DensityField& density) {
    const Grid& grid = density.grid();
    for (const std::int32_t cell : crowdedCells_) crowded_[cell] = 0;
    crowdedCells_.clear();
    if (crowded_.size() != density.density().size()) crowded_.assign(density.density().size(), 0);
    const auto reach = static_cast<std::int32_t>(std::ceil(1.0 + def.lookAhead / grid.cell));
    for (const std::int32_t cell : density.occupied()) {
        if (!(density.density()[cell] > def.densityMin)) continue;
        const Cell c = grid.at(cell);
        for (std::int32_t y = std::max(0, c.y - reach); y <= std::min(grid.height - 1, c.y + reach); ++y) {
            for (std::int32_t x = std::max(0, c.x - reach); x <= std::min(grid.width - 1, c.x + reach); ++x) {
                std::uint8_t& mark = crowded_[grid.index({x, y})];
                if (mark == 0) crowdedCells_.push_back(grid.index({x, y}));
                mark = 1;
            }
        }
    }
}

void UnitCostBuilder::priceCrowd(const UnitCostDef& def, const Environment& environment,
                                 const DensityField& density) {
    const std::span<const float> travelSpeed = environment.travelSpeed();
    const Grid& grid = cost_.grid;
    const bool dense = def.density && !density.density().empty();
    if (dense) {
        markCrowded(def, density);
        const Grid& coarse = density.grid();
        const double ratio = coarse.cell / grid.cell;
        const Vec2 shift = (coarse.origin - grid.origin) / grid.cell;
        for (const std::int32_t cell : crowdedCells_) {
            const Cell c = coarse.at(cell);
            CellRect within;
            centresWithin(shift.x + c.x * ratio, shift.x + (c.x + 1) * ratio, grid.width, within.low.x,
                          within.high.x);
            centresWithin(shift.y + c.y * ratio, shift.y + (c.y + 1) * ratio, grid.height, within.low.y,
                          within.high.y);
            for (std::int32_t y = within.low.y; y <= within.high.y; ++y) {
                for (std::int32_t x = within.low.x; x <= within.high.x; ++x) {
                    const std::int32_t index = grid.index({x, y});
                    priceCell(def, density, index, travelSpeed[index]);
                }
            }
        }
    }
    if (def.gamma == 0.0) return;
    // Cells with discomfort only.
    for (const std::int32_t index : uneasy_) {
        if (dense &&
            crowded_[density.grid().index(density.grid().nearestCell(grid.centre(grid.at(index))))] != 0) {
            continue;
        }
        priceCell(def, density, index, travelSpeed[index]);
    }
}

void UnitCostBuilder::priceCell(const UnitCostDef& def, const DensityField& density, std::int32_t index,
                                double travelSpeed) {
    const CellCost& ground = ground_[index];
    const Vec2 centre = cost_.grid.centre(cost_.grid.at(index));
    const double extra = def.gamma * discomfort_[index];
    const bool dense = def.density && !density.density().empty();
    const auto price = [&](float side, Vec2 along) {
        const double f = dense
                             ? relativeSpeed(def, density, centre + along * def.lookAhead, along, travelSpeed)
                             : 1.0;
        // The ground holds (alpha + beta) / TravelSpeed.
        return static_cast<float>(side * ((def.alpha * f + def.beta + extra) / (f * price_)));
    };
    const CellCost out{price(ground.east, {1.0, 0.0}), price(ground.north, {0.0, 1.0}),
                       price(ground.west, {-1.0, 0.0}), price(ground.south, {0.0, -1.0})};
    if (std::memcmp(&out, &ground, sizeof(CellCost)) == 0) return;
    cost_.cells[index] = out;
    priced_.push_back(index);
    const auto node = std::lower_bound(cost_.nodes.begin(), cost_.nodes.end(), index,
                                       [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    if (node == cost_.nodes.end() || node->cell != index) return;
    hiddenNodes_.push_back({static_cast<std::int32_t>(node - cost_.nodes.begin()), node->unit});
    node->unit = 0.0f;
}

}  // namespace muster
