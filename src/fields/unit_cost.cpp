#include "muster/fields/unit_cost.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fields/discomfort.h"
#include "fields/ground_cost.h"
#include "muster/base/assert.h"

namespace muster {
namespace {


// Speed in direction `along`, relative to the free speed of this ground (SPEC A4).
double relativeSpeed(const UnitCostDef& def, const DensityField& density, Vec2 p, Vec2 along, double travelSpeed) {
    const double crowd = density.densityAt(p);
    if (crowd <= def.densityMin) return 1.0;
    const double flow = std::max(0.0, dot(density.velocityAt(p), along)) / (def.freeSpeed * travelSpeed);
    const double share = std::min(1.0, (crowd - def.densityMin) / (def.densityMax - def.densityMin));
    const double speed = 1.0 + share * (std::min(1.0, flow) - 1.0);
    return std::max(def.minSpeed, speed);
}

// First and last cell of a row or column of `count` cells whose centres lie in [low, high), in cells from the origin.
void centresWithin(double low, double high, std::int32_t count, std::int32_t& first, std::int32_t& last) {
    first = static_cast<std::int32_t>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(count)));
    last = static_cast<std::int32_t>(std::clamp(std::ceil(high - 0.5), 0.0, static_cast<double>(count))) - 1;
}

}  // namespace

void UnitCostBuilder::build(const UnitCostDef& def, const Environment& environment, const DensityField& density,
                            double radius, UnitCost& cost) {
    MUSTER_ASSERT(def.alpha >= 0.0 && def.beta >= 0.0 && def.alpha + def.beta > 0.0 && def.gamma >= 0.0);
    MUSTER_ASSERT(def.freeSpeed > 0.0 && def.densityMax > def.densityMin && def.minSpeed > 0.0);
    updateGround(def, environment, radius);
    cost.grid = grid_;
    cost.radius = radius;
    cost.lowest = lowest_;
    cost.cells = ground_;
    cost.nodes = nodes_;
    updateDiscomfort(def, environment);
    priceCrowd(def, environment, density, cost);
}

// Prices anew those cells of the empty ground round which something changed.
void UnitCostBuilder::updateGround(const UnitCostDef& def, const Environment& environment, double radius) {
    const Grid& grid = environment.grid();
    const double price = def.alpha + def.beta;
    const std::span<const float> clearance = environment.clearance();
    const std::span<const float> travelSpeed = environment.travelSpeed();
    const bool anew = !(grid == grid_) || ground_.empty() || radius != groundRadius_ || price != price_;
    if (!anew && std::equal(clearance.begin(), clearance.end(), clearance_.begin()) &&
        std::equal(travelSpeed.begin(), travelSpeed.end(), travelSpeed_.begin())) {
        return;
    }
    if (!(grid == grid_)) {
        discomfort_.assign(static_cast<std::size_t>(grid.count()), 0.0f);
        uneasy_.clear();
    }
    grid_ = grid;
    groundRadius_ = radius;
    price_ = price;
    clearance_.assign(clearance.begin(), clearance.end());
    travelSpeed_.assign(travelSpeed.begin(), travelSpeed.end());
    lowest_ = priceGround({grid_, clearance_, travelSpeed_}, radius, price, ground_, nodes_);
}

void UnitCostBuilder::updateDiscomfort(const UnitCostDef& def, const Environment& environment) {
    for (const std::int32_t cell : uneasy_) discomfort_[cell] = 0.0f;
    uneasy_.clear();
    if (!def.discomfort) return;
    for (const ObstaclePiece& piece : environment.pieces()) addDiscomfort(def, piece, grid_, discomfort_, uneasy_);
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

void UnitCostBuilder::priceCrowd(const UnitCostDef& def, const Environment& environment, const DensityField& density,
                                 UnitCost& cost) {
    const std::span<const float> travelSpeed = environment.travelSpeed();
    const bool dense = def.density && !density.density().empty();
    if (dense) {
        markCrowded(def, density);
        const Grid& coarse = density.grid();
        const double ratio = coarse.cell / grid_.cell;
        const Vec2 shift = (coarse.origin - grid_.origin) / grid_.cell;
        for (const std::int32_t cell : crowdedCells_) {
            const Cell c = coarse.at(cell);
            std::int32_t left = 0, right = 0, low = 0, high = 0;
            centresWithin(shift.x + c.x * ratio, shift.x + (c.x + 1) * ratio, grid_.width, left, right);
            centresWithin(shift.y + c.y * ratio, shift.y + (c.y + 1) * ratio, grid_.height, low, high);
            for (std::int32_t y = low; y <= high; ++y) {
                for (std::int32_t x = left; x <= right; ++x) {
                    const std::int32_t index = grid_.index({x, y});
                    priceCell(def, density, index, travelSpeed[index], cost);
                }
            }
        }
    }
    if (def.gamma == 0.0) return;
    // Cells with discomfort only.
    for (const std::int32_t index : uneasy_) {
        if (dense && crowded_[density.grid().index(density.grid().nearestCell(grid_.centre(grid_.at(index))))] != 0) {
            continue;
        }
        priceCell(def, density, index, travelSpeed[index], cost);
    }
}

void UnitCostBuilder::priceCell(const UnitCostDef& def, const DensityField& density, std::int32_t index,
                                double travelSpeed, UnitCost& cost) const {
    const CellCost& ground = ground_[index];
    CellCost& out = cost.cells[index];
    const Vec2 centre = grid_.centre(grid_.at(index));
    const double extra = def.gamma * discomfort_[index];
    const bool dense = def.density && !density.density().empty();
    const auto price = [&](float side, Vec2 along) {
        const double f =
            dense ? relativeSpeed(def, density, centre + along * def.lookAhead, along, travelSpeed) : 1.0;
        // The ground holds (alpha + beta) / TravelSpeed.
        return static_cast<float>(side * ((def.alpha * f + def.beta + extra) / (f * price_)));
    };
    out.east = price(ground.east, {1.0, 0.0});
    out.north = price(ground.north, {0.0, 1.0});
    out.west = price(ground.west, {-1.0, 0.0});
    out.south = price(ground.south, {0.0, -1.0});
    if (std::memcmp(&out, &ground, sizeof(CellCost)) == 0) return;
    const auto node = std::lower_bound(cost.nodes.begin(), cost.nodes.end(), index,
                                       [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    if (node != cost.nodes.end() && node->cell == index) node->unit = 0.0f;
}

}  // namespace muster
