#include "geodesics/local_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

// Clearance that landmarks need per spacing, with kClearanceMargin more, to see each other past convex
// corners.
constexpr float kClearancePerSpacing = 1.45f;
constexpr float kClearanceMargin = 0.7f;     // [cells]
constexpr std::size_t kMinReserved = 96;     // Fields with memory from the start.
constexpr std::size_t kPlacesPerField = 2;   // One more field has memory for so many places.
constexpr std::size_t kMaxReserved = 1024;   // Most fields with memory from the start.
constexpr std::size_t kPseudoSources = 256;  // Pseudo-sources in most local fields, at most.

bool precedes(const WallNode& node, std::int32_t cell) {
    return node.cell < cell;
}

}  // namespace

LocalFields::LocalFields(const LocalFieldsDef& def) : def_(def), cache_(def.capacity) {}

void LocalFields::beginStep(const GroundLevel& level, std::uint32_t version) {
    const bool changed = level_ != nullptr && version_ != version;
    level_ = &level;
    version_ = version;
    if (changed) cache_.clear();
    cache_.beginStep();
}

void LocalFields::reserve(std::size_t places) {
    const std::size_t size = 2 * def_.halfWidth + 1;
    cache_.reserve(std::min(kMaxReserved, kMinReserved + places / kPlacesPerField), size * size,
                   kPseudoSources);
}

std::int32_t LocalFields::spacingAt(std::int32_t cell) const {
    const auto perCell = static_cast<float>(1.0 / level_->cost.grid.cell);
    const float clearance = level_->clearance[cell] * perCell;
    const float uniformClearance = level_->uniformClearance[cell] * perCell;
    const auto fits = [&](std::int32_t cells) {
        const auto spacing = static_cast<float>(cells);
        return clearance >= kClearancePerSpacing * spacing + kClearanceMargin && uniformClearance >= spacing;
    };
    std::int32_t spacing = kWidestSpacing;
    while (spacing > 1 && !fits(spacing)) spacing /= 2;
    return spacing;
}

LandmarkSquare LocalFields::squareRound(Vec2 place, std::int32_t spacing) const {
    const Grid& grid = level_->cost.grid;
    const double u = (place.x - grid.origin.x) / grid.cell - 0.5;
    const double v = (place.y - grid.origin.y) / grid.cell - 0.5;
    const auto left = static_cast<std::int32_t>(std::floor(u / spacing)) * spacing;
    const auto low = static_cast<std::int32_t>(std::floor(v / spacing)) * spacing;
    LandmarkSquare square{{}, 0, true};
    for (std::int32_t k = 0; k < 4; ++k) {
        const Cell c{left + (k & 1) * spacing, low + (k >> 1) * spacing};
        if (!grid.contains(c) || level_->blocked(grid.index(c)))
            square.complete = false;
        else
            square.cell[square.count++] = grid.index(c);
    }
    // A place in a door that is too narrow for the cells to show it takes the free cell next to it.
    if (square.count == 0)
        if (const std::int32_t free = level_->freeCellNear(place); free >= 0)
            square.cell[square.count++] = free;
    return square;
}

VisibleLandmarks LocalFields::visibleLandmarks(const StaticGround& ground, Vec2 place) {
    const Grid& grid = level_->cost.grid;
    // On slow ground the cost to a landmark far off says little of the cost to the place.
    const bool slow = ground.unitCost(place) > level_->cost.lowest;
    for (std::int32_t spacing = slow ? 1 : kWidestSpacing; spacing > 0; spacing /= 2) {
        const LandmarkSquare square = squareRound(place, spacing);
        std::array<std::pair<double, std::int32_t>, 4> order;  // Squared distance and landmark, ascending.
        std::int32_t count = 0;
        for (std::int32_t k = 0; k < square.count; ++k) {
            const Vec2 at = grid.centre(grid.at(square.cell[k]));
            // At the closest spacing landmarks out of sight serve too.
            if (spacing > 1 && !ground.lineOfSight(at, place)) continue;
            const std::pair<double, std::int32_t> landmark{lengthSquared(at - place), square.cell[k]};
            std::int32_t rank = count++;
            for (; rank > 0 && landmark < order[rank - 1]; --rank) order[rank] = order[rank - 1];
            order[rank] = landmark;
        }
        if (count == 0) continue;
        VisibleLandmarks visible;
        for (std::int32_t k = 0; k < count; ++k)
            if (const std::int32_t slot = cache_.use(order[k].second); slot >= 0)
                visible.slot[visible.count++] = slot;
            else if (k == 0)
                cache_.request(order[k].second);
        return visible;
    }
    return {};
}

InterpolationStencil LocalFields::stencil(Vec2 place, float unitCost) {
    const Grid& grid = level_->cost.grid;
    const LandmarkSquare square = squareRound(place, spacingAt(grid.index(grid.nearestCell(place))));
    Landmark solved[4];
    std::size_t count = 0;
    for (std::int32_t k = 0; k < square.count; ++k) {
        const std::int32_t slot = cache_.use(square.cell[k]);
        if (slot >= 0)
            solved[count++] = {slot, grid.centre(grid.at(square.cell[k]))};
        else
            cache_.request(square.cell[k]);
    }
    return makeStencil({solved, count}, square.complete, place, unitCost);
}

double LocalFields::squaredCost(const InterpolationStencil& stencil, Vec2 from) const {
    double sum = stencil.offset;
    for (std::int32_t k = 0; k < stencil.count; ++k) {
        const CostField& field = cache_.field(stencil.slot[k]);
        const double reach = def_.halfWidth * field.grid().cell;
        const Vec2 off = from - field.source();
        if (std::fabs(off.x) > reach || std::fabs(off.y) > reach) return kInfiniteCost;
        sum += static_cast<double>(stencil.weight[k]) * field.squaredCost(from);
    }
    return sum;
}

std::int32_t LocalFields::landmarkNear(Vec2 p, std::int32_t fallback) const {
    const Grid& grid = level_->cost.grid;
    const Cell c = grid.nearestCell(p);
    const auto onLattice = [](std::int32_t k, std::int32_t size) {
        return std::min((k + kWidestSpacing / 2) / kWidestSpacing * kWidestSpacing, size - 1);
    };
    const Cell landmark{onLattice(c.x, grid.width), onLattice(c.y, grid.height)};
    if (!level_->blocked(grid.index(landmark))) return grid.index(landmark);
    return level_->blocked(grid.index(c)) ? fallback : grid.index(c);
}

void LocalFields::growWorkers(const ThreadPool& pool) {
    if (std::cmp_less(workers_.size(), pool.threads())) workers_.resize(pool.threads());
}

std::int32_t LocalFields::solveRequested(std::int32_t most, ThreadPool& pool) {
    growWorkers(pool);
    return cache_.solveRequested(most, pool,
                                 [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
                                     solve(landmark, field, workers_[worker]);
                                 });
}

void LocalFields::solveAll(ThreadPool& pool) {
    growWorkers(pool);
    cache_.solveAll(pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

void LocalFields::solve(std::int32_t landmark, CostField& field, Worker& worker) const {
    cropUnitCost(landmark, worker.crop);
    const Grid& grid = level_->cost.grid;
    worker.solver.solve(worker.crop, grid.centre(grid.at(landmark)), {}, field);
}

// Copies the box round a landmark to a unit cost of its own; cells outside the ground become walls.
void LocalFields::cropUnitCost(std::int32_t landmark, UnitCost& crop) const {
    constexpr float kWall = std::numeric_limits<float>::infinity();
    const std::int32_t size = 2 * def_.halfWidth + 1;
    const UnitCost& whole = level_->cost;
    const Grid& grid = whole.grid;
    const Cell middle = grid.at(landmark);
    const Cell low{middle.x - def_.halfWidth, middle.y - def_.halfWidth};
    crop.grid = {grid.origin + Vec2{low.x * grid.cell, low.y * grid.cell}, grid.cell, size, size};
    crop.radius = whole.radius;
    crop.lowest = whole.lowest;
    crop.cells.assign(size * size, {kWall, kWall, kWall, kWall});
    crop.nodes.clear();
    const std::int32_t left = std::max(0, low.x);
    const std::int32_t right = std::min(grid.width - 1, low.x + size - 1);
    for (std::int32_t y = std::max(0, low.y); y <= std::min(grid.height - 1, low.y + size - 1); ++y) {
        const auto from = whole.cells.begin() + grid.index({left, y});
        std::copy(from, from + (right - left + 1), crop.cells.begin() + (y - low.y) * size + (left - low.x));
        auto node = std::lower_bound(whole.nodes.begin(), whole.nodes.end(), grid.index({left, y}), precedes);
        for (; node != whole.nodes.end() && node->cell <= grid.index({right, y}); ++node) {
            crop.nodes.push_back(*node);
            crop.nodes.back().cell = (y - low.y) * size + (grid.at(node->cell).x - low.x);
        }
    }
}

}  // namespace muster
