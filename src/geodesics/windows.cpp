#include "geodesics/windows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kRoomPerSpacing = 1.45f;     // What landmarks that are so many cells apart need to the walls.
constexpr std::size_t kLeastReserved = 96;   // Windows for which there is room from the start...
constexpr std::size_t kPlacesPerWindow = 2;  // ... with one more for so many places...
constexpr std::size_t kMostReserved = 1024;  // ... up to so many.
constexpr std::size_t kRoots = 256;          // Points that straight ways come from, in most windows at most.

bool before(const WallNode& node, std::int32_t cell) {
    return node.cell < cell;
}

}  // namespace

Windows::Windows(const WindowsDef& def) : def_(def), lattice_(def.capacity) {}

void Windows::beginStep(const GroundLevel& ground, std::uint32_t version) {
    const bool changed = ground_ != nullptr && version_ != version;
    ground_ = &ground;
    version_ = version;
    if (changed) lattice_.clear();
    lattice_.beginStep();
}

void Windows::reserve(std::size_t places) {
    const auto size = static_cast<std::size_t>(2 * def_.half + 1);
    lattice_.reserve(std::min(kMostReserved, kLeastReserved + places / kPlacesPerWindow), size * size,
                     kRoots);
}

// The less room there is to walls and to other ground, the closer they lie.
std::int32_t Windows::spacingAt(std::int32_t cell) const {
    const auto perCell = static_cast<float>(1.0 / ground_->cost.grid.cell);
    const float walls = ground_->clearance[cell] * perCell;
    const float others = ground_->uniformClearance[cell] * perCell;
    const auto fits = [&](std::int32_t cells) {
        const auto spacing = static_cast<float>(cells);
        return walls >= kRoomPerSpacing * spacing + 0.7f && others >= spacing;
    };
    std::int32_t spacing = kWidest;
    while (spacing > 1 && !fits(spacing)) spacing /= 2;
    return spacing;
}

// The free corners of the square of landmarks round a place.
Windows::Corners Windows::cornersOf(Vec2 place, std::int32_t spacing) const {
    const Grid& grid = ground_->cost.grid;
    const double u = (place.x - grid.origin.x) / grid.cell - 0.5;
    const double v = (place.y - grid.origin.y) / grid.cell - 0.5;
    const auto left = static_cast<std::int32_t>(std::floor(u / spacing)) * spacing;
    const auto low = static_cast<std::int32_t>(std::floor(v / spacing)) * spacing;
    Corners corners{{}, 0, true};
    for (std::int32_t k = 0; k < 4; ++k) {
        const Cell c{left + (k & 1) * spacing, low + (k >> 1) * spacing};
        if (!grid.contains(c) || ground_->blocked(grid.index(c)))
            corners.square = false;
        else
            corners.cell[corners.count++] = grid.index(c);
    }
    // A place in a door too narrow for the cells to show it has the free cell beside it.
    if (corners.count == 0)
        if (const std::int32_t beside = ground_->freeCellNear(place); beside >= 0)
            corners.cell[corners.count++] = beside;
    return corners;
}

SeenWindows Windows::seen(const StaticGround& still, Vec2 place) {
    const Grid& grid = ground_->cost.grid;
    // On slow ground a landmark some way off says little.
    const bool slow = still.unitCost(place) > ground_->cost.lowest;
    for (std::int32_t spacing = slow ? 1 : kWidest; spacing > 0; spacing /= 2) {
        const Corners corners = cornersOf(place, spacing);
        std::array<std::pair<double, std::int32_t>, 4> order;
        std::int32_t count = 0;
        for (std::int32_t k = 0; k < corners.count; ++k) {
            const Vec2 at = grid.centre(grid.at(corners.cell[k]));
            // At last any landmark must do.
            if (spacing > 1 && !still.lineOfSight(at, place)) continue;
            const std::pair<double, std::int32_t> landmark{lengthSquared(at - place), corners.cell[k]};
            std::int32_t rank = count++;
            for (; rank > 0 && landmark < order[rank - 1]; --rank) order[rank] = order[rank - 1];
            order[rank] = landmark;
        }
        if (count == 0) continue;
        SeenWindows seen;
        for (std::int32_t k = 0; k < count; ++k)
            if (const std::int32_t slot = lattice_.use(order[k].second); slot >= 0)
                seen.slot[seen.count++] = slot;
            else if (k == 0)
                lattice_.wish(order[k].second);
        return seen;
    }
    return {};
}

LandmarkStencil Windows::stencil(Vec2 place, float unit) {
    const Grid& grid = ground_->cost.grid;
    const Corners corners = cornersOf(place, spacingAt(grid.index(grid.nearestCell(place))));
    Landmark known[4];
    std::size_t count = 0;
    for (std::int32_t k = 0; k < corners.count; ++k) {
        const std::int32_t slot = lattice_.use(corners.cell[k]);
        if (slot >= 0)
            known[count++] = {slot, grid.centre(grid.at(corners.cell[k]))};
        else
            lattice_.wish(corners.cell[k]);
    }
    return weighLandmarks({known, count}, corners.square, place, unit);
}

double Windows::square(const LandmarkStencil& stencil, Vec2 from) const {
    double sum = stencil.shift;
    for (std::int32_t k = 0; k < stencil.count; ++k) {
        const CostField& field = lattice_.field(stencil.slot[k]);
        const double reach = def_.half * field.grid().cell;
        const Vec2 off = from - field.source();
        if (std::fabs(off.x) > reach || std::fabs(off.y) > reach)
            return std::numeric_limits<double>::infinity();
        sum += static_cast<double>(stencil.weight[k]) * field.squaredCost(from);
    }
    return sum;
}

std::int32_t Windows::landmarkNear(Vec2 p, std::int32_t other) const {
    const Grid& grid = ground_->cost.grid;
    const Cell c = grid.nearestCell(p);
    const Cell middle{std::min((c.x + kWidest / 2) / kWidest * kWidest, grid.width - 1),
                      std::min((c.y + kWidest / 2) / kWidest * kWidest, grid.height - 1)};
    if (!ground_->blocked(grid.index(middle))) return grid.index(middle);
    return ground_->blocked(grid.index(c)) ? other : grid.index(c);
}

std::int32_t Windows::build(std::int32_t most, ThreadPool& pool) {
    if (static_cast<std::int32_t>(workers_.size()) < pool.threads()) workers_.resize(pool.threads());
    return lattice_.build(most, pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

void Windows::rebuild(ThreadPool& pool) {
    if (static_cast<std::int32_t>(workers_.size()) < pool.threads()) workers_.resize(pool.threads());
    lattice_.rebuild(pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

void Windows::solve(std::int32_t landmark, CostField& field, Worker& worker) const {
    crop(landmark, worker.crop);
    const Grid& grid = ground_->cost.grid;
    worker.solver.solve(worker.crop, grid.centre(grid.at(landmark)), {}, field);
}

// The part of the ground round a landmark, as a ground of its own.
void Windows::crop(std::int32_t landmark, UnitCost& cost) const {
    const std::int32_t size = 2 * def_.half + 1;
    const UnitCost& whole = ground_->cost;
    const Grid& grid = whole.grid;
    const Cell middle = grid.at(landmark);
    const Cell low{middle.x - def_.half, middle.y - def_.half};
    cost.grid = {grid.origin + Vec2{low.x * grid.cell, low.y * grid.cell}, grid.cell, size, size};
    cost.radius = whole.radius;
    cost.lowest = whole.lowest;
    cost.cells.assign(static_cast<std::size_t>(size) * size, {kInfinite, kInfinite, kInfinite, kInfinite});
    cost.nodes.clear();
    const std::int32_t left = std::max(0, low.x);
    const std::int32_t right = std::min(grid.width - 1, low.x + size - 1);
    for (std::int32_t y = std::max(0, low.y); y <= std::min(grid.height - 1, low.y + size - 1); ++y) {
        const auto from = whole.cells.begin() + grid.index({left, y});
        std::copy(from, from + (right - left + 1), cost.cells.begin() + (y - low.y) * size + (left - low.x));
        auto node = std::lower_bound(whole.nodes.begin(), whole.nodes.end(), grid.index({left, y}), before);
        for (; node != whole.nodes.end() && node->cell <= grid.index({right, y}); ++node) {
            cost.nodes.push_back(*node);
            cost.nodes.back().cell = (y - low.y) * size + (grid.at(node->cell).x - low.x);
        }
    }
}

}  // namespace muster
