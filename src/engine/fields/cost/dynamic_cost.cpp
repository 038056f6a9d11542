#include "engine/fields/cost/dynamic_cost.h"

#include <algorithm>
#include <cmath>

#include "engine/fields/cost/crowd_speed.h"

namespace muster {
namespace {

// Relative precision of the time at which the discomfort of a moving obstacle peaks.
constexpr double kPeakPrecision = 0.02;

// Greatest number of cells that are copied for reading in each step.
constexpr std::int64_t kMostWindow = 1 << 14;

bool isZero(const CellCost& c) {
    return c.east == 0.0f && c.north == 0.0f && c.west == 0.0f && c.south == 0.0f;
}

}  // namespace

void DynamicCost::clear() {
    for (const std::int32_t cell : crowdCells_) crowdCost_[cell] = {0.0f, 0.0f, 0.0f, 0.0f};
    crowdCells_.clear();
    movingCost_.clear();
    movingCells_.clear();
    negative_ = false;
    evaluated_.clear();
    nearCrowd_.clear();
    patchCells_.clear();
    blocked_.clear();
    blockedCells_.clear();
}

void DynamicCost::reset(const Grid& ground, const Grid& density) {
    if (!(density == grid_)) {
        grid_ = density;
        locator_ = BilinearLocator(grid_);
        const std::int32_t count = grid_.count();
        crowdCost_.assign(count, {0.0f, 0.0f, 0.0f, 0.0f});
        staticUnit_.assign(count, 0.0f);
        crowdCells_.clear();
        crowdCells_.reserve(count);
        evaluated_.reset(count);
        nearCrowd_.reset(count);
        nearCrowdSums_.reserve(grid_);
        movingGrid_ = Grid::covering(grid_.box(), kMovingCell);
        movingLocator_ = BilinearLocator(movingGrid_);
        movingCost_.reset(movingGrid_);
        patchCells_.reset(movingGrid_);
        window_.reserve(kMostWindow);
    }
    clear();
    if (!(ground == ground_)) {
        ground_ = ground;
        blocked_.reset(ground_);
    }
}

void DynamicCost::update(const Parameters& parameters, const Environment& environment,
                         const DensityField& density, double radius) {
    reset(environment.grid(), density.grid());
    if (grid_.count() == 0) return;
    if (parameters.density.enabled) addCrowd(parameters, density, environment);
    if (parameters.discomfort.enabled && parameters.cost.gamma > 0.0)
        for (const ObstaclePiece& piece : environment.pieces()) addDiscomfortOf(parameters, piece);
    for (const CellRect& area : environment.movingPatchAreas())
        if (!area.empty()) addMovingPatches(environment, area);
    addMovingObstacles(environment, radius);
    updateBounds();
}

// Only cells within the look-ahead of a dense cell can be slowed.
void DynamicCost::addCrowd(const Parameters& parameters, const DensityField& density,
                           const Environment& environment) {
    const Parameters::Density& def = parameters.density;
    const Parameters::Cost& cost = parameters.cost;
    const auto reach = static_cast<std::int32_t>(std::ceil(def.lookAhead / grid_.cell));
    const double openCost = cost.alpha + cost.beta;
    lengthShare_ = static_cast<float>(cost.alpha / openCost);
    timeShare_ = static_cast<float>(cost.beta / openCost);
    for (const std::int32_t dense : density.occupied()) {
        if (!(density.density()[dense] > def.min)) continue;
        const Cell c = grid_.at(dense);
        for (std::int32_t y = std::max(0, c.y - reach); y <= std::min(grid_.height - 1, c.y + reach); ++y)
            for (std::int32_t x = std::max(0, c.x - reach); x <= std::min(grid_.width - 1, c.x + reach);
                 ++x) {
                const std::int32_t cell = grid_.index({x, y});
                if (evaluated_.insert(cell)) evaluateCrowd(parameters, density, environment, cell);
            }
    }
}

void DynamicCost::evaluateCrowd(const Parameters& parameters, const DensityField& density,
                                const Environment& environment, std::int32_t cell) {
    const Parameters::Cost& cost = parameters.cost;
    const double openCost = cost.alpha + cost.beta;
    const Grid& ground = environment.grid();
    const Vec2 p = grid_.centre(grid_.at(cell));
    const double travelSpeed = environment.travelSpeed()[ground.index(ground.nearestCell(p))];
    staticUnit_[cell] = static_cast<float>(openCost / travelSpeed);
    const auto relativeCost = [&](Vec2 direction) {
        const double f = relativeCrowdSpeed(parameters, density, p, direction, travelSpeed);
        return f < 1.0 ? static_cast<float>((cost.alpha * f + cost.beta) / (f * openCost) - 1.0) : 0.0f;
    };
    setCrowdCost(cell, {relativeCost({1.0, 0.0}), relativeCost({0.0, 1.0}), relativeCost({-1.0, 0.0}),
                        relativeCost({0.0, -1.0})});
}

void DynamicCost::setCrowdCost(std::int32_t cell, const CellCost& value) {
    if (isZero(value)) return;
    crowdCells_.push_back(cell);
    crowdCost_[cell] = value;
}

void DynamicCost::addDiscomfortOf(const Parameters& parameters, const ObstaclePiece& piece) {
    if (!piece.moving) return;
    const Parameters::Discomfort& def = parameters.discomfort;
    const Parameters::Cost& cost = parameters.cost;
    const auto scale = static_cast<float>(cost.gamma / (cost.alpha + cost.beta));
    const Vec2 end = piece.centre + piece.velocity * def.time;
    const double reach = piece.radius + def.range;
    const Cell low = movingGrid_.nearestCell(
        {std::min(piece.centre.x, end.x) - reach, std::min(piece.centre.y, end.y) - reach});
    const Cell high = movingGrid_.nearestCell(
        {std::max(piece.centre.x, end.x) + reach, std::max(piece.centre.y, end.y) + reach});
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const Vec2 p = movingGrid_.centre({x, y});
            const auto g = static_cast<float>(discomfortAt(def, piece, p, kPeakPrecision));
            setMovingCost({x, y}, std::max(movingCost_[{x, y}], scale * g));
        }
}

// Moving patches multiply the unit cost by the ratio of the travel speeds without and with them.
void DynamicCost::addMovingPatches(const Environment& environment, const CellRect& area) {
    const RasterView travelSpeed = environment.travelSpeed();
    const RasterView patchSpeed = environment.staticPatchSpeed();
    const Cell low = movingGrid_.nearestCell(ground_.centre(area.low));
    const Cell high = movingGrid_.nearestCell(ground_.centre(area.high));
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const Cell cell{x, y};
            if (patchCells_[cell] != 0) continue;
            patchCells_.touch(cell) = 1;
            const std::int32_t at = ground_.index(ground_.nearestCell(movingGrid_.centre({x, y})));
            const float staticSpeed = patchSpeed[at] < kUnreachableCost ? patchSpeed[at] : 1.0f;
            if (travelSpeed[at] != staticSpeed)
                setMovingCost(cell, (1.0f + movingCost_[cell]) * (staticSpeed / travelSpeed[at]) - 1.0f);
        }
}

void DynamicCost::addMovingObstacles(const Environment& environment, double radius) {
    const std::span<const float> clearance = environment.clearance();
    const std::span<const float> staticClearance = environment.staticClearance();
    const auto staticLeast = static_cast<float>(radius);
    // Half a cell less than the radius: characters that touch the obstacle stand on the cells at its rim.
    const auto most = static_cast<float>(radius - 0.5 * ground_.cell);
    for (const CellRect& area : environment.movingObstacleAreas()) {
        if (area.empty()) continue;
        for (std::int32_t y = area.low.y; y <= area.high.y; ++y)
            for (std::int32_t x = area.low.x; x <= area.high.x; ++x) {
                const std::int32_t cell = ground_.index({x, y});
                if (clearance[cell] >= most || staticClearance[cell] < staticLeast) continue;
                if (blocked_[{x, y}] == 0) blockedCells_.push_back({x, y});
                blocked_.touch({x, y}) = 1;
            }
    }
}

void DynamicCost::setMovingCost(Cell cell, float value) {
    if (value == 0.0f) return;
    float& cost = movingCost_.touch(cell);
    if (cost == 0.0f) movingCells_.push_back(cell);
    negative_ = negative_ || value < 0.0f;
    cost = std::min(value, kBlocked);
}

void DynamicCost::copyToWindow() {
    CellRect& rect = windowCells_;
    rect = {{movingGrid_.width, movingGrid_.height}, {-1, -1}};
    for (const Cell cell : movingCells_) {
        rect.low = {std::min(rect.low.x, cell.x - 1), std::min(rect.low.y, cell.y - 1)};
        rect.high = {std::max(rect.high.x, cell.x + 1), std::max(rect.high.y, cell.y + 1)};
    }
    windowWidth_ = rect.high.x - rect.low.x + 1;
    const auto count = static_cast<std::int64_t>(windowWidth_) * (rect.high.y - rect.low.y + 1);
    if (movingCells_.empty() || count > kMostWindow) {
        rect = {{0, 0}, {-1, -1}};
        return;
    }
    window_.assign(count, 0.0f);
    for (const Cell cell : movingCells_)
        window_[(cell.y - rect.low.y) * windowWidth_ + cell.x - rect.low.x] = movingCost_[cell];
}

void DynamicCost::updateBounds() {
    crowdBounds_ = {};
    for (const std::int32_t cell : crowdCells_) {
        const Cell c = grid_.at(cell);
        for (std::int32_t y = std::max(0, c.y - 1); y <= std::min(grid_.height - 1, c.y + 1); ++y)
            for (std::int32_t x = std::max(0, c.x - 1); x <= std::min(grid_.width - 1, c.x + 1); ++x)
                nearCrowd_.insert(grid_.index({x, y}));
        crowdBounds_.extend(grid_.centre(c), grid_.cell);
    }
    nearCrowdSums_.build(grid_, nearCrowd_);
    movingBounds_ = {};
    for (const Cell cell : movingCells_) movingBounds_.extend(movingGrid_.centre(cell), kMovingCell);
    copyToWindow();
    blockedBounds_ = {};
    for (const Cell cell : blockedCells_) {
        movingBounds_.extend(ground_.centre(cell), ground_.cell);
        blockedBounds_.extend(ground_.centre(cell), ground_.cell);
    }
}

}  // namespace muster
