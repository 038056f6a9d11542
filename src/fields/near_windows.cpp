#include "fields/near_windows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
// Landmarks this far apart [cells], where the room to walls is at least so many cells.
constexpr std::int32_t kSpacings[] = {4, 2, 1};
constexpr float kRoomPerSpacing = 1.45f;

bool before(const WallNode& node, std::int32_t cell) { return node.cell < cell; }

}  // namespace

NearWindows::NearWindows(std::int32_t capacity) : lattice_(capacity) {}

void NearWindows::beginStep(const StaticGround& ground) {
    const bool changed = ground_ != nullptr && version_ != ground.version();
    ground_ = &ground;
    version_ = ground.version();
    if (changed) lattice_.clear();
    lattice_.beginStep();
}

// The free corners of the square of landmarks round a place.
NearWindows::Corners NearWindows::cornersOf(Vec2 place) const {
    const Grid& grid = ground_->fine().grid;
    const double u = (place.x - grid.origin.x) / grid.cell - 0.5;
    const double v = (place.y - grid.origin.y) / grid.cell - 0.5;
    const float room = ground_->wallRoom(grid.index(grid.nearestCell(place))) / static_cast<float>(grid.cell);
    std::int32_t spacing = 1;
    for (const std::int32_t s : kSpacings)
        if (room >= kRoomPerSpacing * static_cast<float>(s) + 0.7f) {
            spacing = s;
            break;
        }
    const auto left = static_cast<std::int32_t>(std::floor(u / spacing)) * spacing;
    const auto low = static_cast<std::int32_t>(std::floor(v / spacing)) * spacing;
    Corners corners{{}, 0, true};
    for (std::int32_t k = 0; k < 4; ++k) {
        const Cell c{left + (k & 1) * spacing, low + (k >> 1) * spacing};
        if (!grid.contains(c) || ground_->blocked(grid.index(c))) corners.square = false;
        else corners.cell[corners.count++] = grid.index(c);
    }
    // A place in a door too narrow for the cells to show it has the free cell beside it.
    if (corners.count == 0)
        if (const std::int32_t beside = ground_->freeCellNear(place); beside >= 0) corners.cell[corners.count++] = beside;
    return corners;
}

LandmarkStencil NearWindows::stencil(Vec2 place) {
    const Corners corners = cornersOf(place);
    const Grid& grid = ground_->fine().grid;
    Landmark known[4];
    std::size_t count = 0;
    for (std::int32_t k = 0; k < corners.count; ++k) {
        const std::int32_t slot = lattice_.use(corners.cell[k]);
        if (slot >= 0) known[count++] = {slot, grid.centre(grid.at(corners.cell[k]))};
        else lattice_.wish(corners.cell[k]);
    }
    return weighLandmarks({known, count}, corners.square, place, ground_->unit(place));
}

double NearWindows::square(const LandmarkStencil& stencil, Vec2 from) const {
    double sum = stencil.shift;
    for (std::int32_t k = 0; k < stencil.count; ++k) {
        const CostField& field = lattice_.field(stencil.slot[k]);
        const double reach = kHalf * field.grid().cell;
        const Vec2 off = from - field.source();
        if (std::fabs(off.x) > reach || std::fabs(off.y) > reach) return std::numeric_limits<double>::infinity();
        sum += static_cast<double>(stencil.weight[k]) * field.squareBetween(from);
    }
    return sum;
}

std::int32_t NearWindows::landmarkNear(Vec2 p, std::int32_t other) const {
    const Grid& grid = ground_->fine().grid;
    constexpr std::int32_t kSpacing = kSpacings[0];
    const Cell c = grid.nearestCell(p);
    const Cell middle{std::min((c.x + kSpacing / 2) / kSpacing * kSpacing, grid.width - 1),
                      std::min((c.y + kSpacing / 2) / kSpacing * kSpacing, grid.height - 1)};
    if (!ground_->blocked(grid.index(middle))) return grid.index(middle);
    return ground_->blocked(grid.index(c)) ? other : grid.index(c);
}

void NearWindows::build(std::int32_t most, ThreadPool& pool) {
    if (static_cast<std::int32_t>(workers_.size()) < pool.threads()) workers_.resize(pool.threads());
    lattice_.build(most, pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

void NearWindows::rebuild(ThreadPool& pool) {
    if (static_cast<std::int32_t>(workers_.size()) < pool.threads()) workers_.resize(pool.threads());
    lattice_.rebuild(pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

void NearWindows::solve(std::int32_t landmark, CostField& field, Worker& worker) const {
    crop(landmark, worker.crop);
    const Grid& grid = ground_->fine().grid;
    worker.solver.solve(worker.crop, grid.centre(grid.at(landmark)), {}, field);
}

// The part of the ground round a landmark, as a ground of its own.
void NearWindows::crop(std::int32_t landmark, UnitCost& cost) const {
    constexpr std::int32_t kSize = 2 * kHalf + 1;
    const UnitCost& whole = ground_->fine();
    const Grid& grid = whole.grid;
    const Cell middle = grid.at(landmark);
    const Cell low{middle.x - kHalf, middle.y - kHalf};
    cost.grid = {grid.origin + Vec2{low.x * grid.cell, low.y * grid.cell}, grid.cell, kSize, kSize};
    cost.radius = whole.radius;
    cost.lowest = whole.lowest;
    cost.cells.assign(static_cast<std::size_t>(kSize) * kSize, {kInfinite, kInfinite, kInfinite, kInfinite});
    cost.nodes.clear();
    const std::int32_t left = std::max(0, low.x);
    const std::int32_t right = std::min(grid.width - 1, low.x + kSize - 1);
    for (std::int32_t y = std::max(0, low.y); y <= std::min(grid.height - 1, low.y + kSize - 1); ++y) {
        const auto from = whole.cells.begin() + grid.index({left, y});
        std::copy(from, from + (right - left + 1), cost.cells.begin() + (y - low.y) * kSize + (left - low.x));
        auto node = std::lower_bound(whole.nodes.begin(), whole.nodes.end(), grid.index({left, y}), before);
        for (; node != whole.nodes.end() && node->cell <= grid.index({right, y}); ++node) {
            cost.nodes.push_back(*node);
            cost.nodes.back().cell = (y - low.y) * kSize + (grid.at(node->cell).x - low.x);
        }
    }
}

}  // namespace muster
