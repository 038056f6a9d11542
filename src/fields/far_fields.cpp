#include "fields/far_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr std::int32_t kCapacity = 1024;
constexpr double kLeastSpacing = 4.0;    // Between landmarks [m].
constexpr double kMostLandmarks = 100.0; // Over a formation of a metre per place, about.
// A landmark counts for a place only where the way between them is not much longer than the straight line.
constexpr double kInLine = 1.15;

}  // namespace

FarFields::FarFields() : lattice_(kCapacity) {}

void FarFields::beginStep(const StaticGround& ground, std::size_t places) {
    double apart = kLeastSpacing;
    while (static_cast<double>(places) / (apart * apart) > kMostLandmarks) apart *= 2.0;
    const Grid& grid = ground.coarse().grid;
    const auto spacing = std::max(2, static_cast<std::int32_t>(apart / grid.cell + 0.5));
    const bool anew = ground_ == nullptr || version_ != ground.version() || spacing != spacing_;
    const bool changed = ground_ != nullptr && anew;
    ground_ = &ground;
    version_ = ground.version();
    spacing_ = spacing;
    if (anew) {
        movedWidth_ = grid.width / spacing + 2;
        moved_.assign(static_cast<std::size_t>(movedWidth_) * (grid.height / spacing + 2), -2);
    }
    if (changed) lattice_.clear();
    lattice_.beginStep();
}

// The lattice point's own cell, or the free one nearest to it within a third of the spacing.
std::int32_t FarFields::freeNear(Cell point) {
    std::int32_t& known = moved_[static_cast<std::size_t>(point.y) * movedWidth_ + point.x];
    if (known != -2) return known;
    known = -1;
    const UnitCost& cost = ground_->coarse();
    const Cell middle{point.x * spacing_, point.y * spacing_};
    std::int32_t nearest = std::max(1, spacing_ / 3) * std::max(1, spacing_ / 3) + 1;
    const std::int32_t reach = std::max(1, spacing_ / 3);
    for (std::int32_t dy = -reach; dy <= reach; ++dy)
        for (std::int32_t dx = -reach; dx <= reach; ++dx) {
            const Cell c{middle.x + dx, middle.y + dy};
            if (dx * dx + dy * dy >= nearest || !cost.grid.contains(c) || cost.wall(cost.grid.index(c))) continue;
            nearest = dx * dx + dy * dy;
            known = cost.grid.index(c);
        }
    return known;
}

FarFields::Corners FarFields::cornersOf(Vec2 place) {
    const Grid& grid = ground_->coarse().grid;
    const double u = std::clamp((place.x - grid.origin.x) / grid.cell - 0.5, 0.0, grid.width - 1.0);
    const double v = std::clamp((place.y - grid.origin.y) / grid.cell - 0.5, 0.0, grid.height - 1.0);
    const Cell low{static_cast<std::int32_t>(u) / spacing_, static_cast<std::int32_t>(v) / spacing_};
    Corners corners{{}, 0, true};
    for (std::int32_t k = 0; k < 4; ++k) {
        const Cell point{low.x + (k & 1), low.y + (k >> 1)};
        const std::int32_t cell = freeNear(point);
        if (cell != grid.index({point.x * spacing_, point.y * spacing_})) corners.square = false;
        if (cell >= 0) corners.cell[corners.count++] = cell;
    }
    return corners;
}

bool FarFields::sees(const CostField& field, Vec2 place) const {
    const double square = field.squareBetween(place);
    const double line = kInLine * ground_->lineCost(place, field.source()) + 1.5 * field.grid().cell;
    return square <= line * line;
}

LandmarkStencil FarFields::stencil(Vec2 place) {
    const Corners corners = cornersOf(place);
    const Grid& grid = ground_->coarse().grid;
    Landmark known[4];
    std::size_t count = 0;
    std::int32_t best = -1;
    for (std::int32_t k = 0; k < corners.count; ++k) {
        const std::int32_t slot = lattice_.use(corners.cell[k]);
        if (slot < 0) {
            lattice_.wish(corners.cell[k]);
            continue;
        }
        if (best < 0 || lattice_.field(slot).squareBetween(place) < lattice_.field(best).squareBetween(place)) best = slot;
        if (sees(lattice_.field(slot), place)) known[count++] = {slot, grid.centre(grid.at(corners.cell[k]))};
    }
    // Where none sees the place, the one from which the way is shortest must do.
    if (count == 0 && best >= 0 && std::isfinite(lattice_.field(best).squareBetween(place)))
        known[count++] = {best, lattice_.field(best).source()};
    return weighLandmarks({known, count}, corners.square, place, ground_->unit(place));
}

double FarFields::square(const LandmarkStencil& stencil, Vec2 from) const {
    double sum = stencil.shift;
    for (std::int32_t k = 0; k < stencil.count; ++k)
        sum += static_cast<double>(stencil.weight[k]) * lattice_.field(stencil.slot[k]).squareBetween(from);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

bool FarFields::build(std::int32_t most, ThreadPool& pool) {
    if (static_cast<std::int32_t>(solvers_.size()) < pool.threads()) solvers_.resize(pool.threads());
    const UnitCost& cost = ground_->coarse();
    return lattice_.build(most, pool, [&](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solvers_[worker].solve(cost, cost.grid.centre(cost.grid.at(landmark)), {}, field);
    });
}

void FarFields::rebuild(ThreadPool& pool) {
    if (static_cast<std::int32_t>(solvers_.size()) < pool.threads()) solvers_.resize(pool.threads());
    const UnitCost& cost = ground_->coarse();
    lattice_.rebuild(pool, [&](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solvers_[worker].solve(cost, cost.grid.centre(cost.grid.at(landmark)), {}, field);
    });
}

}  // namespace muster
