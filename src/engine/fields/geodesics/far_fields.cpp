#include "engine/fields/geodesics/far_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr std::int32_t kCapacity = 1024;  // Greatest number of fields.
// Number of fields and pseudo-sources for which there is memory at first.
constexpr std::size_t kReservedFields = 64, kReservedSources = 512;
constexpr double kMinSpacing = 4.0;  // Least distance between landmarks [m].
// Approximate number of landmarks over a formation of one place per square metre.
constexpr double kMaxLandmarks = 100.0;
// Ratio to the straight line up to which the path from a landmark to a place is nearly straight, with
// kSlackCells cells more. Only such landmarks are interpolated.
constexpr double kNearlyStraight = 1.15;
constexpr double kSlackCells = 1.5;

}  // namespace

FarFields::FarFields() : cache_(kCapacity) {}

bool FarFields::beginStep(const StaticGround& ground, std::size_t places) {
    double metres = kMinSpacing;
    while (static_cast<double>(places) / (metres * metres) > kMaxLandmarks) metres *= 2.0;
    const Grid& grid = ground.coarse().grid;
    const auto spacing = std::max(2, static_cast<std::int32_t>(std::floor(metres / grid.cell + 0.5)));
    const bool isNew = ground_ == nullptr || version_ != ground.version() || spacing != spacing_;
    const bool changed = ground_ != nullptr && isNew;
    const bool sameLattice = spacing == spacing_;
    const std::uint32_t before = version_;
    ground_ = &ground;
    version_ = ground.version();
    spacing_ = spacing;
    if (isNew) resetLattices();
    if (changed && sameLattice)
        dropChangedFarFields(ground, before, changes_, cache_);
    else if (changed)
        cache_.clear();
    cache_.beginStep();
    return changed;
}

std::int32_t FarFields::cellsOfField() const {
    if (ground_->hasWideCoarse()) return (2 * kFarFieldHalfWidth + 1) * (2 * kFarFieldHalfWidth + 1);
    return std::max(1, ground_->coarse().grid.count());
}

void FarFields::resetLattices() {
    if (ground_->open() || ground_->coarse().cells.empty()) return;
    lattice_.reset(ground_->coarse().grid, spacing_);
    slowLattice_.reset(ground_->coarse().grid, std::max(1, spacing_ / 2));
}

void FarFields::bind(const StaticGround& ground) {
    if (!cache_.begun() || spacing_ < 1) return;
    if (kept_ && version_ != ground.version()) cache_.loseFields([](std::int32_t) { return true; });
    kept_ = false;
    ground_ = &ground;
    version_ = ground.version();
    resetLattices();
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
    if (ground_->coarse().cells.empty()) return {};
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
        const double squared = covers(slot, place) ? cache_.field(slot).squaredCost(place) : kInfiniteCost;
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

// Beyond the box of a field nothing is known.
bool FarFields::covers(std::int32_t slot, Vec2 from) const {
    if (!ground_->hasWideCoarse()) return true;
    const Vec2 off = from - cache_.field(slot).source();
    const double reach = kFarFieldHalfWidth * ground_->coarse().grid.cell;
    return std::fabs(off.x) < reach && std::fabs(off.y) < reach;
}

double FarFields::squaredCost(const InterpolationStencil& stencil, Vec2 from) const {
    for (std::int32_t k = 0; k < stencil.count; ++k)
        if (!covers(stencil.slot[k], from)) return kInfiniteCost;
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

void FarFields::growWorkers(const ThreadPool& pool) {
    if (std::cmp_less(workers_.size(), pool.threads())) workers_.resize(pool.threads());
}

void FarFields::reserve(const StaticGround& ground) {
    if (!ground.hasCoarse()) return;
    cache_.reserve(kReservedFields, ground.coarse().grid.count(), kReservedSources);
}

std::int32_t FarFields::solveRequested(std::int32_t most, ThreadPool& pool, SharedFarFields* shared) {
    growWorkers(pool);
    const std::int32_t solved = cache_.solveRequested(
        most, pool, [&](std::int32_t landmark, CostField& field, std::int32_t worker) {
            const CostField* const known = shared == nullptr ? nullptr : shared->find(landmark);
            if (known == nullptr)
                solve(landmark, field, workers_[worker]);
            else
                field = *known;
        });
    for (std::int32_t k = 0; shared != nullptr && k < solved; ++k)
        shared->keep(cache_.landmark(cache_.count() - solved + k), cache_.field(cache_.count() - solved + k),
                     pool);
    return solved;
}

void FarFields::keepFieldsOf(FarFields& before) {
    if (before.ground_ == nullptr) return;
    cache_.keepFieldsOf(before.cache_);
    workers_ = std::move(before.workers_);
    version_ = before.version_;
    kept_ = true;
}

void FarFields::solveMissing(ThreadPool& pool) {
    growWorkers(pool);
    cache_.solveMissing(pool, [this](std::int32_t landmark, CostField& field, std::int32_t worker) {
        solve(landmark, field, workers_[worker]);
    });
}

// Fast marching does not reach partially blocked cells, or only around the wall; they get the cost across
// their free side.
void FarFields::solve(std::int32_t landmark, CostField& field, Worker& worker) const {
    if (ground_->hasWideCoarse()) return solveInBox(landmark, field, worker);
    const UnitCost& cost = ground_->coarse();
    worker.solver.solve(cost, cost.grid.centre(cost.grid.at(landmark)), {}, field);
    for (const StaticGround::PartiallyBlockedCell& partial : ground_->partiallyBlockedCells())
        field.lowerValue(partial.cell, field.value(partial.neighbour) + partial.cost);
}

void FarFields::solveInBox(std::int32_t landmark, CostField& field, Worker& worker) const {
    const UnitCost& whole = ground_->coarse();
    const CellRect box = farFieldBox(*ground_, landmark);
    const Vec2 shift{box.low.x * whole.grid.cell, box.low.y * whole.grid.cell};
    UnitCost& crop = worker.crop;
    crop.grid = {whole.grid.origin + shift, whole.grid.cell, box.high.x - box.low.x + 1,
                 box.high.y - box.low.y + 1};
    crop.radius = whole.radius;
    crop.lowest = whole.lowest;
    crop.cells.clear();
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y) {
        const auto row = whole.cells.begin() + whole.grid.index({box.low.x, y});
        crop.cells.insert(crop.cells.end(), row, row + crop.grid.width);
        crop.cells.back().east = crop.cells[crop.cells.size() - crop.grid.width].west = kUnreachableCost;
    }
    for (std::int32_t x = 0; x < crop.grid.width; ++x) {
        crop.cells[x].south = kUnreachableCost;
        crop.cells[crop.grid.index({x, crop.grid.height - 1})].north = kUnreachableCost;
    }
    worker.solver.solve(crop, whole.grid.centre(whole.grid.at(landmark)), {}, field);
    const auto inBox = [&](Cell c) { return Cell{c.x - box.low.x, c.y - box.low.y}; };
    for (const StaticGround::PartiallyBlockedCell& partial :
         ground_->partiallyBlockedCellsIn(box.low.y, box.high.y))
        if (!box.common({partial.cell, partial.cell}).empty() &&
            !box.common({partial.neighbour, partial.neighbour}).empty())
            field.lowerValue(inBox(partial.cell), field.value(inBox(partial.neighbour)) + partial.cost);
}

}  // namespace muster
