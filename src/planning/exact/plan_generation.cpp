#include "planning/exact/plan_generation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "planning/exact/unit_cost_archive.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// How far off reached ground a character still finds back to it [cells].
constexpr std::int32_t kReach = 4;
// A front first goes to characters within this many times the way of the place's incumbent, and a little more
// [m].
constexpr double kReachFactor = 1.5;
constexpr double kReachMore = 2.0;
// ... but to all where that is not much farther.
constexpr double kWorthwhile = 0.6;
// Plans for which a front that had to go on does so from the start, at least.
constexpr std::int32_t kWidePlans = 16;
// Fields are a discretisation; a lower bound of their values must allow for their error.
constexpr double kBoundShare = 0.95;

template <class T>
void copy(std::span<const T> from, std::vector<T>& to) {
    to.assign(from.begin(), from.end());
}

}  // namespace

void PlanGeneration::freeze(const PlanDef& def, const PlanInput& input, const PlanGeneration& former) {
    def_ = def;
    copy(input.characters, characters_);
    copy(input.supply, supply_);
    copy(input.places, places_);
    copy(input.demand, demand_);
    copy(input.usable, usable_);
    copy(input.incumbent, incumbent_);
    cost_ = *input.unitCost;
    solved_ = 0;
    setWide(former);
    valid_ = true;
    prepare();
}

// A front that had to go on once will have to again soon: better within its share of the work than at its
// end.
void PlanGeneration::setWide(const PlanGeneration& former) {
    wide_.assign(places_.size(), 0);
    if (!former.valid_ || former.wide_.size() != wide_.size()) return;
    for (std::size_t j = 0; j < wide_.size(); ++j)
        if (former.wide_[j] > 0) wide_[j] = static_cast<std::uint8_t>(former.wide_[j] - 1);
}

void PlanGeneration::prepare() {
    regions_.label(cost_);
    characterRegion_.clear();
    placeRegion_.clear();
    standing_.clear();
    for (const Vec2 p : characters_) {
        standing_.push_back(regions_.standing(p));
        characterRegion_.push_back(regions_.at(standing_.back()));
    }
    for (const Vec2 p : places_) placeRegion_.push_back(regions_.at(p));
    // Fields beyond the number of places keep their memory for later.
    if (fields_.size() < places_.size()) fields_.resize(places_.size());
    known_.assign(places_.size(), 0);
    setWaiting();
    setReach();
}

// True where its incumbent place is one that it can take and come to.
bool PlanGeneration::holds(std::int32_t character) const {
    const std::int32_t j = incumbent_[character];
    return j >= 0 && usable(j) && supplyOf(character) > 0.0 && characterRegion_[character] == placeRegion_[j];
}

void PlanGeneration::setWaiting() {
    waits_.assign(characters_.size(), -1);
    for (std::int32_t i = 0; i < characters(); ++i) {
        if (holds(i) || characterRegion_[i] < 0) continue;
        double nearest = kInfinite;
        for (std::int32_t j = 0; j < places(); ++j) {
            if (!usable(j) || placeRegion_[j] != characterRegion_[i]) continue;
            const double d = lengthSquared(places_[j] - characters_[i]);
            if (d >= nearest) continue;
            nearest = d;
            waits_[i] = j;
        }
    }
}

// Places that nobody holds may be anybody's; one that is cut off holds none.
void PlanGeneration::setReach() {
    reach_.assign(places_.size(), -1.0);
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t j = incumbent_[i];
        if (holds(i))
            reach_[j] = std::max(reach_[j], kReachFactor * distance(characters_[i], places_[j]) + kReachMore);
    }
    for (std::int32_t j = 0; j < places(); ++j) {
        double farthest = 0.0;
        for (const Vec2 p : characters_) farthest = std::max(farthest, distance(p, places_[j]));
        // Where stopping early would save little, it is not worth a second front.
        if (reach_[j] < 0.0 || reach_[j] > kWorthwhile * farthest) reach_[j] = kInfinite;
    }
}

bool PlanGeneration::met(std::int32_t character, std::int32_t place) const {
    if (characterRegion_[character] != placeRegion_[place] || supplyOf(character) <= 0.0) return false;
    if (incumbent_[character] == place || waits_[character] == place) return true;
    return def_.reassign &&
           (wide_[place] > 0 || distance(characters_[character], places_[place]) <= reach_[place]);
}

void PlanGeneration::solve(std::int32_t end, ThreadPool& pool, std::vector<FieldWorker>& workers) {
    end = std::clamp(end, solved_, places());
    if (static_cast<std::int32_t>(workers.size()) < pool.threads()) workers.resize(pool.threads());
    const auto work = [&](std::int32_t item, std::int32_t worker) {
        solveOne(solved_ + item, workers[worker]);
    };
    pool.run(end - solved_, std::ref(work));
    solved_ = end;
}

void PlanGeneration::widen(std::span<const std::int32_t> places, ThreadPool& pool,
                           std::vector<FieldWorker>& workers) {
    if (static_cast<std::int32_t>(workers.size()) < pool.threads()) workers.resize(pool.threads());
    // Not all for equally long, so that not all have to go on again in one plan.
    for (const std::int32_t j : places)
        wide_[j] = static_cast<std::uint8_t>(kWidePlans + (j * 5) % kWidePlans);
    const auto work = [&](std::int32_t item, std::int32_t worker) {
        solveOne(places[item], workers[worker]);
    };
    pool.run(static_cast<std::int32_t>(places.size()), std::ref(work));
}

// The front stops when it has met all who might take the place; without them there is no front.
void PlanGeneration::solveOne(std::int32_t place, FieldWorker& worker) {
    worker.targets.clear();
    if (placeRegion_[place] < 0 || !usable(place) || (def_.reassign && demandOf(place) <= 0.0)) return;
    for (std::int32_t i = 0; i < characters(); ++i)
        if (met(i, place)) worker.targets.push_back(standing_[i]);
    if (worker.targets.empty()) return;
    worker.solver.solve(cost_, places_[place], worker.targets, fields_[place]);
    known_[place] = 1;
}

const CostField* PlanGeneration::field(std::int32_t place) const {
    if (!valid_ || place < 0 || place >= solved_ || !known_[place]) return nullptr;
    return &fields_[place];
}

double PlanGeneration::pairCost(std::int32_t character, std::int32_t place) const {
    const CostField* of = field(place);
    if (of == nullptr || characterRegion_[character] != placeRegion_[place]) return kInfinite;
    const double straight = distance(characters_[character], places_[place]);
    if (!def_.geodesic) return straight;
    if (!met(character, place)) return kBoundShare * static_cast<double>(cost_.lowest) * straight;
    const Vec2 from = standing_[character];
    return std::max(0.0, of->cost(from)) + distance(characters_[character], from);
}

template <class Self, class Archive>
void PlanGeneration::visitInputs(Self& self, Archive& archive) {
    archive(self.def_, self.characters_, self.supply_, self.places_, self.demand_, self.usable_,
            self.incumbent_, self.solved_, self.wide_);
}

void PlanGeneration::save(Writer& archive) const {
    archive(valid_);
    if (!valid_) return;
    visitInputs(*this, archive);
    saveUnitCost(archive, cost_);
}

bool PlanGeneration::load(Reader& archive, std::int32_t& progress) {
    valid_ = false;
    progress = 0;
    bool present = false;
    archive(present);
    if (!archive.ok()) return false;
    if (!present) return true;
    visitInputs(*this, archive);
    progress = solved_;
    solved_ = 0;
    if (!loadUnitCost(archive, cost_) || progress < 0 || progress > places()) return false;
    if (wide_.size() != places_.size()) return false;
    const PlanInput input{characters_, supply_, places_, demand_, usable_, incumbent_, &cost_};
    if (!checkPlan(def_, input).ok()) return false;
    valid_ = true;
    prepare();
    return true;
}

void PlanGeneration::hash(Hasher& archive) const {
    archive(valid_);
    if (!valid_) return;
    visitInputs(*this, archive);
    archive(cost_.grid, cost_.radius, cost_.lowest);
}

bool nearestReached(const CostField& field, const Grid& grid, Vec2 p, Cell& found) {
    const Cell from = grid.nearestCell(p);
    double best = kInfinite;
    for (std::int32_t y = std::max(0, from.y - kReach); y <= std::min(grid.height - 1, from.y + kReach); ++y)
        for (std::int32_t x = std::max(0, from.x - kReach); x <= std::min(grid.width - 1, from.x + kReach);
             ++x) {
            const double d = distance(p, grid.centre({x, y}));
            if (d >= best || !std::isfinite(field.value({x, y}))) continue;
            best = d;
            found = {x, y};
        }
    return best < kInfinite;
}

}  // namespace muster
