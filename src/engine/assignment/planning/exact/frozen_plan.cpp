#include "engine/assignment/planning/exact/frozen_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/assignment/planning/assigner.h"
#include "engine/assignment/planning/exact/unit_cost_archive.h"

namespace muster {
namespace {

// Distance at which a character off the field still finds back to a reached cell [cells].
constexpr std::int32_t kReturnCells = 4;
// Radius of a front, as a factor of the distance of the place's incumbent with kRadiusMargin [m] added.
constexpr double kRadiusFactor = 1.5;
constexpr double kRadiusMargin = 2.0;
// Share of the distance of the farthest character above which the radius of a front becomes unlimited.
constexpr double kUnlimitedShare = 0.6;
// Least number of plans for which a front that had to be extended stays unlimited.
constexpr std::int32_t kUnlimitedPlans = 16;
// Share of the straight line's cost that is a lower bound of a field's value in spite of its discretisation
// error.
constexpr double kBoundShare = 0.95;

void growWorkers(std::vector<FieldWorker>& workers, const ThreadPool& pool) {
    if (std::cmp_less(workers.size(), pool.threads())) workers.resize(pool.threads());
}

}  // namespace

void FrozenPlan::freeze(const PlanDef& def, const PlanInput& input, const UnitCost& cost,
                        const FrozenPlan& former) {
    def_ = def;
    copySpan(input.characters, characters_);
    copySpan(input.supply, supply_);
    copySpan(input.places, places_);
    copySpan(input.demand, demand_);
    copySpan(input.usable, usable_);
    copySpan(input.incumbent, incumbent_);
    copySpan(input.known, known_);
    copySpan(input.slowness, slowness_);
    copySpan(input.characterClass, characterClass_);
    copySpan(input.placeClass, placeClass_);
    unitCost_ = cost;
    solved_ = 0;
    inheritUnlimited(former);
    valid_ = true;
    derive();
}

// A front that had to be extended once will probably have to be again. Within its share of the work that
// costs less than at the end of the plan.
void FrozenPlan::inheritUnlimited(const FrozenPlan& former) {
    unlimited_.assign(places_.size(), 0);
    if (!former.valid_ || former.unlimited_.size() != unlimited_.size()) return;
    for (std::size_t j = 0; j < unlimited_.size(); ++j)
        if (former.unlimited_[j] > 0) unlimited_[j] = static_cast<std::uint8_t>(former.unlimited_[j] - 1);
}

void FrozenPlan::derive() {
    regions_.label(unitCost_);
    characterRegion_.clear();
    placeRegion_.clear();
    freePoint_.clear();
    for (const Vec2 p : characters_) {
        freePoint_.push_back(regions_.nearestFreePoint(p));
        characterRegion_.push_back(regions_.at(freePoint_.back()));
    }
    for (const Vec2 p : places_) placeRegion_.push_back(regions_.at(p));
    if (fields_.size() < places_.size()) fields_.resize(places_.size());
    fieldKnown_.assign(places_.size(), 0);
    findWaitingPlaces();
    setFrontRadii();
}

// True where the incumbent place of a character is usable and in its region.
bool FrozenPlan::holdsIncumbent(std::int32_t character) const {
    const std::int32_t j = incumbent_[character];
    return j >= 0 && usable(j) && supplyOf(character) > 0.0 && characterRegion_[character] == placeRegion_[j];
}

void FrozenPlan::findWaitingPlaces() {
    waitingPlace_.assign(characters_.size(), -1);
    for (std::int32_t i = 0; i < characters(); ++i) {
        if (holdsIncumbent(i) || characterRegion_[i] < 0) continue;
        double nearest = kInfiniteCost;
        for (std::int32_t j = 0; j < places(); ++j) {
            if (!usable(j) || placeRegion_[j] != characterRegion_[i]) continue;
            const double d = lengthSquared(places_[j] - characters_[i]);
            if (d >= nearest) continue;
            nearest = d;
            waitingPlace_[i] = j;
        }
    }
}

// Places without an incumbent may go to any character, so that their fronts are unlimited.
void FrozenPlan::setFrontRadii() {
    frontRadius_.assign(places_.size(), -1.0);
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t j = incumbent_[i];
        if (holdsIncumbent(i))
            frontRadius_[j] = std::max(frontRadius_[j],
                                       kRadiusFactor * distance(characters_[i], places_[j]) + kRadiusMargin);
    }
    for (std::int32_t j = 0; j < places(); ++j) {
        double farthest = 0.0;
        for (const Vec2 p : characters_) farthest = std::max(farthest, distance(p, places_[j]));
        if (frontRadius_[j] < 0.0 || frontRadius_[j] > kUnlimitedShare * farthest)
            frontRadius_[j] = kInfiniteCost;
    }
}

bool FrozenPlan::isTarget(std::int32_t character, std::int32_t place) const {
    if (characterRegion_[character] != placeRegion_[place] || supplyOf(character) <= 0.0) return false;
    if (incumbent_[character] == place || waitingPlace_[character] == place) return true;
    return def_.reassign &&
           (unlimited_[place] > 0 || distance(characters_[character], places_[place]) <= frontRadius_[place]);
}

void FrozenPlan::solve(std::int32_t end, ThreadPool& pool, std::vector<FieldWorker>& workers) {
    end = std::clamp(end, solved_, places());
    growWorkers(workers, pool);
    const auto work = [&](std::int32_t item, std::int32_t worker) {
        solveField(solved_ + item, workers[worker]);
    };
    pool.run(end - solved_, std::ref(work));
    solved_ = end;
}

void FrozenPlan::solveUnlimited(std::span<const std::int32_t> places, ThreadPool& pool,
                                std::vector<FieldWorker>& workers) {
    growWorkers(workers, pool);
    // The number of plans varies, so that not all fronts have to be extended again in one plan.
    for (const std::int32_t j : places)
        unlimited_[j] = static_cast<std::uint8_t>(kUnlimitedPlans + (j * 5) % kUnlimitedPlans);
    const auto work = [&](std::int32_t item, std::int32_t worker) {
        solveField(places[item], workers[worker]);
    };
    pool.run(static_cast<std::int32_t>(places.size()), std::ref(work));
}

// The front stops when it has reached all targets; without targets there is no front.
void FrozenPlan::solveField(std::int32_t place, FieldWorker& worker) {
    worker.targets.clear();
    if (placeRegion_[place] < 0 || !usable(place) || (def_.reassign && demandOf(place) <= 0.0)) return;
    for (std::int32_t i = 0; i < characters(); ++i)
        if (isTarget(i, place)) worker.targets.push_back(freePoint_[i]);
    if (worker.targets.empty()) return;
    worker.solver.solve(unitCost_, places_[place], worker.targets, fields_[place]);
    fieldKnown_[place] = 1;
}

const CostField* FrozenPlan::field(std::int32_t place) const {
    if (!valid_ || place < 0 || place >= solved_ || !fieldKnown_[place]) return nullptr;
    return &fields_[place];
}

double FrozenPlan::pairCost(std::int32_t character, std::int32_t place) const {
    const CostField* toPlace = field(place);
    if (toPlace == nullptr || characterRegion_[character] != placeRegion_[place]) return kInfiniteCost;
    const bool isKnown = !known_.empty() && known_[character] >= 0.0f && incumbent_[character] == place;
    if (isKnown) return known_[character];
    const double slowness = slowness_.empty() ? 1.0 : static_cast<double>(slowness_[character]);
    const double straight = slowness * distance(characters_[character], places_[place]);
    if (!def_.geodesic) return straight;
    if (!isTarget(character, place)) return kBoundShare * static_cast<double>(unitCost_.lowest) * straight;
    const Vec2 from = freePoint_[character];
    const double walk = std::max(0.0, toPlace->cost(from)) + distance(characters_[character], from);
    return slowness * walk;
}

template <class Self, class Archive>
void FrozenPlan::visitInputs(Self& self, Archive& archive) {
    archive(self.def_, self.characters_, self.supply_, self.places_, self.demand_, self.usable_,
            self.incumbent_, self.known_, self.slowness_, self.characterClass_, self.placeClass_,
            self.solved_, self.unlimited_);
}

void FrozenPlan::save(Writer& archive) const {
    archive(valid_);
    if (!valid_) return;
    visitInputs(*this, archive);
    saveUnitCost(archive, unitCost_);
}

bool FrozenPlan::load(Reader& archive, std::int32_t& progress) {
    valid_ = false;
    progress = 0;
    bool present = false;
    archive(present);
    if (!archive.ok()) return false;
    if (!present) return true;
    visitInputs(*this, archive);
    progress = solved_;
    solved_ = 0;
    if (!loadUnitCost(archive, unitCost_) || progress < 0 || progress > places()) return false;
    if (unlimited_.size() != places_.size()) return false;
    PlanInput input{characters_, supply_, places_, demand_, usable_, incumbent_};
    input.known = known_;
    input.slowness = slowness_;
    input.characterClass = characterClass_;
    input.placeClass = placeClass_;
    if (!validatePlan(def_, input).ok() || !validateUnitCost(unitCost_).ok()) return false;
    valid_ = true;
    derive();
    return true;
}

void FrozenPlan::hash(Hasher& archive) const {
    archive(valid_);
    if (!valid_) return;
    visitInputs(*this, archive);
    archive(unitCost_.grid, unitCost_.radius, unitCost_.lowest);
}

bool nearestReached(const CostField& field, const Grid& grid, Vec2 p, Cell& found) {
    const Cell from = grid.nearestCell(p);
    const Cell low{std::max(0, from.x - kReturnCells), std::max(0, from.y - kReturnCells)};
    const Cell high{std::min(grid.width - 1, from.x + kReturnCells),
                    std::min(grid.height - 1, from.y + kReturnCells)};
    double best = kInfiniteCost;
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const double d = distance(p, grid.centre({x, y}));
            if (d >= best || !std::isfinite(field.value({x, y}))) continue;
            best = d;
            found = {x, y};
        }
    return best < kInfiniteCost;
}

}  // namespace muster
