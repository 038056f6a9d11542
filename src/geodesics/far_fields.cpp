#include "geodesics/far_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr std::int32_t kCapacity = 1024;  // Fields.
constexpr double kMinSpacing = 4.0;       // Between landmarks [m].
constexpr double kMaxLandmarks = 100.0;   // Over a formation of one place per square metre, about.
// The path from a landmark to a place is nearly straight where it costs at most this times the straight line,
// and kSlackCells cells more. Only such landmarks are interpolated.
constexpr double kNearlyStraight = 1.15;
constexpr double kSlackCells = 1.5;

}  // namespace

FarFields::FarFields() : cache_(kCapacity) {}

void FarFields::beginStep(const StaticGround& ground, std::size_t places) {
    double metres = kMinSpacing;
    while (static_cast<double>(places) / (metres * metres) > kMaxLandmarks) metres *= 2.0;
    const Grid& grid = ground.coarse().grid;
    const auto spacing = std::max(2, static_cast<std::int32_t>(metres / grid.cell + 0.5));
    const bool isNew = ground_ == nullptr || version_ != ground.version() || spacing != spacing_;
    const bool changed = ground_ != nullptr && isNew;
    ground_ = &ground;
    version_ = ground.version();
    spacing_ = spacing;
    if (isNew) {
        lattice_.reset(grid, spacing);
        slowLattice_.reset(grid, std::max(1, spacing / 2));
    }
    if (changed) cache_.clear();
    cache_.beginStep();
}

void FarFields::LandmarkLattice::reset(const Grid& grid, std::int32_t cells) {
    spacing = cells;
    width = grid.width / cells + 2;
    landmark.assign(static_cast<std::size_t>(width) * (grid.height / cells + 2), -2);
}

// The cell of a lattice point, or the nearest free one within a third of the spacing; -1 for none.
std::int32_t FarFields::landmarkOf(Cell point, LandmarkLattice& lattice) const {
    std::int32_t& landmark = lattice.landmark[point.y * lattice.width + point.x];
    if (landmark != -2) return landmark;
    landmark = -1;
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
            landmark = cost.grid.index(c);
        }
    return landmark;
}

LandmarkSquare FarFields::squareRound(Vec2 place, LandmarkLattice& lattice) const {
    const Grid& grid = ground_->coarse().grid;
    const std::int32_t spacing = lattice.spacing;
    const double u = std::clamp((place.x - grid.origin.x) / grid.cell - 0.5, 0.0, grid.width - 1.0);
    const double v = std::clamp((place.y - grid.origin.y) / grid.cell - 0.5, 0.0, grid.height - 1.0);
    const Cell low{static_cast<std::int32_t>(u) / spacing, static_cast<std::int32_t>(v) / spacing};
    LandmarkSquare square{{}, 0, true};
    for (std::int32_t k = 0; k < 4; ++k) {
        const Cell point{low.x + (k & 1), low.y + (k >> 1)};
        const std::int32_t cell = landmarkOf(point, lattice);
        if (cell != grid.index({point.x * spacing, point.y * spacing})) square.complete = false;
        if (cell >= 0) square.cell[square.count++] = cell;
    }
    return square;
}

bool FarFields::nearlyStraight(const CostField& field, Vec2 place, double squaredCost) const {
    const double slack = kSlackCells * field.grid().cell * ground_->unitCost(place);
    const double limit = kNearlyStraight * ground_->lineCost(place, field.source()) + slack;
    return squaredCost <= limit * limit;
}

InterpolationStencil FarFields::stencil(Vec2 place) {
    const LandmarkSquare square = squareRound(place, isSlow(place) ? slowLattice_ : lattice_);
    const Grid& grid = ground_->coarse().grid;
    Landmark straight[4];
    Landmark indirect[4];
    std::size_t straightCount = 0;
    std::size_t indirectCount = 0;
    for (std::int32_t k = 0; k < square.count; ++k) {
        const std::int32_t slot = cache_.use(square.cell[k]);
        if (slot < 0) {
            cache_.request(square.cell[k]);
            continue;
        }
        const double squared = cache_.field(slot).squaredCost(place);
        const Landmark landmark{slot, grid.centre(grid.at(square.cell[k])),
                                std::sqrt(std::max(0.0, squared))};
        if (nearlyStraight(cache_.field(slot), place, squared))
            straight[straightCount++] = landmark;
        else
            indirect[indirectCount++] = landmark;
    }
    // Where no path is nearly straight, the landmark of the cheapest path serves.
    const auto cheaper = [](const Landmark& a, const Landmark& b) { return a.cost < b.cost; };
    if (straightCount == 0 && indirectCount > 0) {
        const Landmark& best = *std::min_element(indirect, indirect + indirectCount, cheaper);
        if (std::isfinite(best.cost)) straight[straightCount++] = best;
    }
    InterpolationStencil stencil = makeStencil({straight, straightCount}, square.complete, place,
                                               ground_->unitCost(place));
    stencil.slowUnitCost = isSlow(place) ? ground_->unitCost(place) : 0.0f;
    // On ground of several unit costs the other landmarks bound the cost.
    if (!ground_->uniform() && stencil.count > 0)
        for (std::size_t k = 0; k < indirectCount && stencil.count < 4; ++k) stencil.addBound(indirect[k]);
    return stencil;
}

double FarFields::squaredCost(const InterpolationStencil& stencil, Vec2 from) const {
    if (!ground_->uniform()) return boundedSquaredCost(stencil, from);
    double sum = stencil.offset;
    for (std::int32_t k = 0; k < stencil.count; ++k)
        sum += static_cast<double>(stencil.weight[k]) * cache_.field(stencil.slot[k]).squaredCost(from);
    return std::isfinite(sum) ? sum : kInfiniteCost;
}

// Squared costs have kinks where the unit cost changes, so that their weighted mean may be far off. The
// triangle inequality bounds it: |c(x,L) - c(L,y)| <= c(x,y) <= c(x,L) + c(L,y). Fronts from outside reach
// places on slow ground almost as plane waves, so there costs are interpolated instead of their squares.
double FarFields::boundedSquaredCost(const InterpolationStencil& stencil, Vec2 from) const {
    const bool planeWave = stencil.slowUnitCost != 0.0f && ground_->unitCost(from) != stencil.slowUnitCost;
    double sum = planeWave ? 0.0 : stencil.offset;
    double lower = 0.0;
    double upper = kInfiniteCost;
    for (std::int32_t k = 0; k < stencil.count; ++k) {
        const double weight = stencil.weight[k];
        const double square = cache_.field(stencil.slot[k]).squaredCost(from);
        const double cost = std::sqrt(std::max(0.0, square));
        const double toPlace = stencil.toPlace[k];
        if (std::isfinite(cost + toPlace)) {
            sum += weight * (planeWave ? cost : square);
            lower = std::max(lower, std::fabs(cost - toPlace));
            upper = std::min(upper, cost + toPlace);
        } else if (weight != 0.0) {
            return kInfiniteCost;
        }
    }
    const double cost = planeWave ? sum : std::sqrt(std::max(0.0, sum));
    // A single landmark may lie on the other side of slow ground.
    const double raised = stencil.weight[0] == 1.0f ? std::max(cost, static_cast<double>(stencil.toPlace[0]))
                                                    : cost;
    const double bounded = std::max(lower, std::min(raised, upper));
    return bounded * bounded;
}

void FarFields::growSolvers(const ThreadPool& pool) {
    if (std::cmp_less(solvers_.size(), pool.threads())) solvers_.resize(pool.threads());
}

std::int32_t FarFields::solveRequested(std::int32_t most, ThreadPool& pool) {
    growSolvers(pool);
    return cache_.solveRequested(most, pool,
                                 [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
                                     solve(landmark, field, solvers_[worker]);
                                 });
}

void FarFields::solveAll(ThreadPool& pool) {
    growSolvers(pool);
    cache_.solveAll(pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, solvers_[worker]);
    });
}

// Fast marching does not reach partially blocked cells, or only around the wall; they get the cost across
// their free side.
void FarFields::solve(std::int32_t landmark, CostField& field, EikonalSolver& solver) const {
    const UnitCost& cost = ground_->coarse();
    solver.solve(cost, cost.grid.centre(cost.grid.at(landmark)), {}, field);
    for (const StaticGround::PartiallyBlockedCell& partial : ground_->partiallyBlockedCells())
        field.lowerValue(partial.cell, field.value(partial.neighbour) + partial.cost);
}

}  // namespace muster
