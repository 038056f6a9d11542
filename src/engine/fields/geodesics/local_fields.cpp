#include "engine/fields/geodesics/local_fields.h"

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
constexpr float kClearanceMargin = 0.7f;     // Clearance that landmarks need beyond that [cells].
constexpr std::size_t kMinReserved = 96;     // Number of fields with memory from the start.
constexpr std::size_t kPlacesPerField = 2;   // Number of places for which one more field has memory.
constexpr std::size_t kMaxReserved = 1024;   // Greatest number of fields with memory from the start.
constexpr std::size_t kPseudoSources = 256;  // Pseudo-sources in most local fields on uniform ground.

}  // namespace

LocalFields::LocalFields(const LocalFieldsDef& def) : def_(def), cache_(def.capacity) {}

void LocalFields::beginStep(const GroundLevel& level) {
    const bool changed = level_.has_value() && version_ != level.version();
    level_ = level;
    if (changed) dropChanged();
    version_ = level.version();
    cache_.beginStep();
}

// A field depends on the ground in its box only.
bool LocalFields::isChanged(std::int32_t landmark) const {
    const CellRect box = boxRound(landmark);
    return std::any_of(changes_.begin(), changes_.end(),
                       [&](const CellRect& area) { return !area.common(box).empty(); });
}

void LocalFields::dropChanged() {
    changes_.clear();
    if (!level_->changesSince(version_, changes_)) return cache_.clear();
    cache_.drop([&](std::int32_t landmark) { return isChanged(landmark); });
}

void LocalFields::bind(const GroundLevel& level) {
    if (!cache_.begun()) return;
    level_ = level;
    changes_.clear();
    if (kept_ && version_ != level.version()) {
        const bool known = level.changesSince(version_, changes_);
        cache_.loseFields([&](std::int32_t landmark) { return !known || isChanged(landmark); });
    }
    kept_ = false;
    version_ = level.version();
}

void LocalFields::reserve(std::size_t places) {
    const std::size_t size = 2 * def_.halfWidth + 1;
    // Places on slow ground have four fields each, with more pseudo-sources.
    const std::size_t fields = kMinReserved + (slow_ ? 4 * places : places / kPlacesPerField);
    cache_.reserve(std::min(kMaxReserved, fields), size * size, slow_ ? size * size / 2 : kPseudoSources);
}

// A field that nobody reads brings the memory of one thread to its size.
void LocalFields::warmUp(const GroundLevel& level) {
    if (!workers_.empty()) return;
    slow_ = !level.uniform();
    workers_.resize(1);
    const std::optional<GroundLevel> before = std::exchange(level_, level);
    const std::size_t size = 2 * def_.halfWidth + 1;
    workers_[0].crop.nodes.reserve(size * size);
    CostField field;
    const Grid& grid = level.grid();
    solve(grid.index({grid.width / 2, grid.height / 2}), field, workers_[0]);
    level_ = before;
}

std::int32_t LocalFields::spacingAt(std::int32_t cell) const {
    const auto perCell = static_cast<float>(1.0 / level_->grid().cell);
    const float clearance = level_->clearance(cell) * perCell;
    const float uniformClearance = level_->uniformClearance(cell) * perCell;
    const auto fits = [&](std::int32_t cells) {
        const auto spacing = static_cast<float>(cells);
        return clearance >= kClearancePerSpacing * spacing + kClearanceMargin && uniformClearance >= spacing;
    };
    std::int32_t spacing = kWidestSpacing;
    while (spacing > 1 && !fits(spacing)) spacing /= 2;
    return spacing;
}

LandmarkSquare LocalFields::squareRound(Vec2 place, std::int32_t spacing) const {
    const Grid& grid = level_->grid();
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
    const Grid& grid = level_->grid();
    // On slow ground the cost to a landmark far off says little of the cost to the place.
    const bool slow = ground.unitCost(place) > level_->lowestUnitCost();
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
    const Grid& grid = level_->grid();
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
    const Grid& grid = level_->grid();
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

void LocalFields::keepFieldsOf(LocalFields& before) {
    if (!before.level_.has_value()) return;
    cache_.keepFieldsOf(before.cache_);
    workers_ = std::move(before.workers_);
    version_ = before.version_;
    kept_ = true;
}

void LocalFields::solveMissing(ThreadPool& pool) {
    growWorkers(pool);
    cache_.solveMissing(pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

void LocalFields::solve(std::int32_t landmark, CostField& field, Worker& worker) const {
    level_->unitCost(boxRound(landmark), worker.scratch, worker.crop);
    const Grid& grid = level_->grid();
    worker.solver.solve(worker.crop, grid.centre(grid.at(landmark)), {}, field);
}

// Some of its cells may lie off the ground.
CellRect LocalFields::boxRound(std::int32_t landmark) const {
    const Cell middle = level_->grid().at(landmark);
    return {{middle.x - def_.halfWidth, middle.y - def_.halfWidth},
            {middle.x + def_.halfWidth, middle.y + def_.halfWidth}};
}

}  // namespace muster
