#include "geodesics/far_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr std::int32_t kCapacity = 1024;
constexpr double kLeastSpacing = 4.0;     // Between landmarks [m].
constexpr double kMostLandmarks = 100.0;  // Over a formation of a metre per place, about.
// A landmark counts for a place only where the way between them is not much longer than the straight line.
constexpr double kInLine = 1.15;
constexpr double kCellsOff = 1.5;  // ... but for so many cells.

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
        wide_.reset(grid, spacing);
        narrow_.reset(grid, std::max(1, spacing / 2));
    }
    if (changed) lattice_.clear();
    lattice_.beginStep();
}

void FarFields::Lattice::reset(const Grid& grid, std::int32_t cells) {
    spacing = cells;
    width = grid.width / cells + 2;
    moved.assign(static_cast<std::size_t>(width) * (grid.height / cells + 2), -2);
}

// The lattice point's own cell, or the free one nearest to it within a third of the spacing.
std::int32_t FarFields::freeNear(Cell point, Lattice& lattice) const {
    std::int32_t& known = lattice.moved[static_cast<std::size_t>(point.y) * lattice.width + point.x];
    if (known != -2) return known;
    known = -1;
    const UnitCost& cost = ground_->coarse();
    const Cell middle{point.x * lattice.spacing, point.y * lattice.spacing};
    const std::int32_t reach = std::max(1, lattice.spacing / 3);
    std::int32_t nearest = reach * reach + 1;
    for (std::int32_t dy = -reach; dy <= reach; ++dy)
        for (std::int32_t dx = -reach; dx <= reach; ++dx) {
            const Cell c{middle.x + dx, middle.y + dy};
            if (dx * dx + dy * dy >= nearest || !cost.grid.contains(c) || cost.wall(cost.grid.index(c)))
                continue;
            nearest = dx * dx + dy * dy;
            known = cost.grid.index(c);
        }
    return known;
}

FarFields::Corners FarFields::cornersOf(Vec2 place, Lattice& lattice) const {
    const Grid& grid = ground_->coarse().grid;
    const std::int32_t spacing = lattice.spacing;
    const double u = std::clamp((place.x - grid.origin.x) / grid.cell - 0.5, 0.0, grid.width - 1.0);
    const double v = std::clamp((place.y - grid.origin.y) / grid.cell - 0.5, 0.0, grid.height - 1.0);
    const Cell low{static_cast<std::int32_t>(u) / spacing, static_cast<std::int32_t>(v) / spacing};
    Corners corners{{}, 0, true};
    for (std::int32_t k = 0; k < 4; ++k) {
        const Cell point{low.x + (k & 1), low.y + (k >> 1)};
        const std::int32_t cell = freeNear(point, lattice);
        if (cell != grid.index({point.x * spacing, point.y * spacing})) corners.square = false;
        if (cell >= 0) corners.cell[corners.count++] = cell;
    }
    return corners;
}

bool FarFields::sees(const CostField& field, Vec2 place, double square) const {
    const double slack = kCellsOff * field.grid().cell * ground_->unitCost(place);
    const double line = kInLine * ground_->lineCost(place, field.source()) + slack;
    return square <= line * line;
}

LandmarkStencil FarFields::stencil(Vec2 place) {
    const Corners corners = cornersOf(place, slow(place) ? narrow_ : wide_);
    const Grid& grid = ground_->coarse().grid;
    Landmark known[4];
    Landmark unseen[4];
    std::size_t count = 0;
    std::size_t others = 0;
    for (std::int32_t k = 0; k < corners.count; ++k) {
        const std::int32_t slot = lattice_.use(corners.cell[k]);
        if (slot < 0) {
            lattice_.wish(corners.cell[k]);
            continue;
        }
        const double square = lattice_.field(slot).squaredCost(place);
        const Landmark landmark{slot, grid.centre(grid.at(corners.cell[k])),
                                std::sqrt(std::max(0.0, square))};
        if (sees(lattice_.field(slot), place, square))
            known[count++] = landmark;
        else
            unseen[others++] = landmark;
    }
    // Where none sees the place, the one from which the way is shortest must do.
    const auto nearer = [](const Landmark& a, const Landmark& b) { return a.cost < b.cost; };
    if (count == 0 && others > 0) {
        const Landmark& best = *std::min_element(unseen, unseen + others, nearer);
        if (std::isfinite(best.cost)) known[count++] = best;
    }
    LandmarkStencil stencil = weighLandmarks({known, count}, corners.square, place, ground_->unitCost(place));
    stencil.unit = slow(place) ? ground_->unitCost(place) : 0.0f;
    // On uneven ground the others tell how long a way is at least and at most.
    if (!ground_->uniform() && stencil.count > 0)
        for (std::size_t k = 0; k < others && stencil.count < 4; ++k) stencil.addBound(unseen[k]);
    return stencil;
}

double FarFields::square(const LandmarkStencil& stencil, Vec2 from) const {
    if (!ground_->uniform()) return squareWithin(stencil, from);
    double sum = stencil.shift;
    for (std::int32_t k = 0; k < stencil.count; ++k)
        sum += static_cast<double>(stencil.weight[k]) * lattice_.field(stencil.slot[k]).squaredCost(from);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

// Squared costs bend where ground becomes slow, so that their mean may be far off: but no way is longer than
// one by a landmark, nor shorter than the ways to a landmark differ. From outside fronts come to places on
// slow ground almost plane, so that costs themselves are what interpolates well.
double FarFields::squareWithin(const LandmarkStencil& stencil, Vec2 from) const {
    const bool plane = stencil.unit != 0.0f && ground_->unitCost(from) != stencil.unit;
    double sum = plane ? 0.0 : stencil.shift;
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    for (std::int32_t k = 0; k < stencil.count; ++k) {
        const double weight = stencil.weight[k];
        const double square = lattice_.field(stencil.slot[k]).squaredCost(from);
        const double cost = std::sqrt(std::max(0.0, square));
        const double own = stencil.own[k];
        if (std::isfinite(cost + own)) {
            sum += weight * (plane ? cost : square);
            least = std::max(least, std::fabs(cost - own));
            most = std::min(most, cost + own);
        } else if (weight != 0.0) {
            return std::numeric_limits<double>::infinity();
        }
    }
    const double cost = plane ? sum : std::sqrt(std::max(0.0, sum));
    // One alone may lie on the other side of slow ground.
    const double between = stencil.weight[0] == 1.0f ? std::max(cost, static_cast<double>(stencil.own[0]))
                                                     : cost;
    const double within = std::max(least, std::min(between, most));
    return within * within;
}

std::int32_t FarFields::build(std::int32_t most, ThreadPool& pool) {
    if (static_cast<std::int32_t>(solvers_.size()) < pool.threads()) solvers_.resize(pool.threads());
    return lattice_.build(most, pool, [&](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, solvers_[worker]);
    });
}

void FarFields::solve(std::int32_t landmark, CostField& field, EikonalSolver& solver) const {
    const UnitCost& cost = ground_->coarse();
    solver.solve(cost, cost.grid.centre(cost.grid.at(landmark)), {}, field);
    for (const StaticGround::PartiallyBlockedCell& beside : ground_->partiallyBlockedCells())
        field.lowerValue(beside.cell, field.value(beside.neighbour) + beside.cost);
}

void FarFields::rebuild(ThreadPool& pool) {
    if (static_cast<std::int32_t>(solvers_.size()) < pool.threads()) solvers_.resize(pool.threads());
    lattice_.rebuild(pool, [&](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, solvers_[worker]);
    });
}

}  // namespace muster
