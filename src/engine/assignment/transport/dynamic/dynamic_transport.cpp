#include "engine/assignment/transport/dynamic/dynamic_transport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr double kMostUnits = 1125899906842624.0;  // Greatest number of units, 2^50: sums of units are exact.
// Number of near places of a character, and of its main place, that are looked at.
constexpr std::int32_t kTransportNearPlaces = 6;
constexpr std::int32_t kTransportNearCharacters = 6;
// Approximate number of characters whose near places are looked at in a step.
constexpr std::int32_t kCharactersPerStep = 100;
// Number of pairs of whole rows and columns that are bounded in a step.
constexpr std::int32_t kScannedPairs = 12000;
constexpr std::size_t kKeptPerScan = 8;  // Number of pairs of a row or column that are evaluated.
constexpr std::int64_t kWork = 250000;  // Number of nodes and candidates that the pivots of a step may touch.
constexpr std::size_t kBlock = 64;      // Number of candidates of which the best one enters.
constexpr double kToleranceShare = 1e-4;  // Tolerance as a share of the mean cost^p of a unit.

double amountOf(std::span<const double> amounts, std::int32_t k) {
    return amounts.empty() ? 1.0 : amounts[k];
}

}  // namespace

// Counts in whole units, so that flows are exact. A power of two keeps amounts like 1 or 0.5 exact, too.
void DynamicTransport::countUnits(const TransportInput& input) {
    const AssignmentInput& positions = input.positions;
    double supply = 0.0, demand = 0.0;
    for (std::int32_t i = 0; i < tree_.characters(); ++i)
        if (positions.isPresent(i)) supply += amountOf(input.supply, i);
    for (std::int32_t j = 0; j < tree_.places(); ++j)
        if (positions.isUsable(j)) demand += amountOf(input.demand, j);
    const double total = std::max({1.0, supply, demand});
    unitsPerAmount_ = 1.0;
    while (unitsPerAmount_ * 2.0 * total <= kMostUnits) unitsPerAmount_ *= 2.0;
    const auto units = [&](double amount) {
        return static_cast<std::int64_t>(std::floor(amount * unitsPerAmount_ + 0.5));
    };
    supply_.clear();
    demand_.clear();
    for (std::int32_t i = 0; i < tree_.characters(); ++i)
        supply_.push_back(positions.isPresent(i) ? units(amountOf(input.supply, i)) : 0);
    for (std::int32_t j = 0; j < tree_.places(); ++j)
        demand_.push_back(positions.isUsable(j) ? units(amountOf(input.demand, j)) : 0);
}

std::int64_t DynamicTransport::levelOf(const TransportInput& input, std::int32_t character,
                                       std::int32_t place) const {
    const AssignmentClasses& classes = input.classes;
    return classes.character.empty() || classes.character[character] == classes.place[place] ? 0 : 1;
}

void DynamicTransport::evaluateTree(const TransportInput& input, CostOracle& costs, ThreadPool& pool) {
    arcs_.clear();
    pairs_.clear();
    for (std::int32_t v = 0; v < tree_.root(); ++v) {
        AssignmentPair pair;
        if (!tree_.pairOf(v, pair.character, pair.place)) continue;
        arcs_.push_back(v);
        pairs_.push_back(pair);
    }
    pairCosts_.resize(pairs_.size());
    costs.evaluate(pairs_, pairCosts_, pool);
    double sum = 0.0;
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
        const AssignmentPair pair = pairs_[k];
        tree_.arcCost(arcs_[k]) = {levelOf(input, pair.character, pair.place), power_(pairCosts_[k])};
        sum += tree_.arcCost(arcs_[k]).value;
    }
    tolerance_ = 1e-12 + kToleranceShare * sum / static_cast<double>(std::max<std::size_t>(1, arcs_.size()));
    tree_.findDuals();
}

void DynamicTransport::add(std::int32_t character, std::int32_t place) {
    if (demand_[place] > 0) pairs_.push_back({character, place});
}

// Collects the neighbourhood of a character: places near it and near its main place, and the places of others
// near it. A character in a place of another class looks at all classes.
void DynamicTransport::collectNearOf(const TransportInput& input, std::int32_t i) {
    const AssignmentInput& positions = input.positions;
    const std::int32_t main = tree_.mainPlace(i);
    const bool settled = main >= 0 && levelOf(input, i, main) == 0;
    const auto suits = [&](std::int32_t j) {
        return demand_[j] > 0 && (!settled || levelOf(input, i, j) == 0);
    };
    NearestPoints near;
    near.find(placeCells_, positions.places, positions.characters[i], kTransportNearPlaces, suits);
    for (std::int32_t k = 0; k < near.size(); ++k) add(i, near[k]);
    if (main >= 0) {
        near.find(placeCells_, positions.places, positions.places[main], kTransportNearPlaces + 1, suits);
        for (std::int32_t k = 0; k < near.size(); ++k) add(i, near[k]);
    }
    near.find(characterCells_, positions.characters, positions.characters[i], kTransportNearCharacters,
              [&](std::int32_t other) { return other != i && supply_[other] > 0; });
    for (std::int32_t k = 0; k < near.size(); ++k)
        tree_.forPlacesOf(near[k], [&](std::int32_t j) {
            if (suits(j)) add(i, j);
        });
}

void DynamicTransport::collectNear(const TransportInput& input) {
    const AssignmentInput& positions = input.positions;
    placeCells_.sort(positions.places, NearestPoints::cellEdge(positions.places));
    characterCells_.sort(positions.characters, NearestPoints::cellEdge(positions.characters));
    const std::int32_t period = std::max(1, tree_.characters() / kCharactersPerStep);
    for (auto i = static_cast<std::int32_t>(round_ % static_cast<std::uint32_t>(period));
         i < tree_.characters(); i += period)
        if (supply_[i] > 0) collectNearOf(input, i);
}

// Keeps a pair where its reduced cost may be negative.
void DynamicTransport::consider(const TransportInput& input, CostOracle& costs, std::int32_t i,
                                std::int32_t j) {
    if (supply_[i] == 0 || demand_[j] == 0) return;
    const double line = distance(input.positions.characters[i], input.positions.places[j]);
    LevelCost cost{levelOf(input, i, j), power_(leastUnitCost_ * line)};
    const LevelCost limit{0, -tolerance_};
    const std::int32_t head = tree_.nodeOfPlace(j);
    if (!(tree_.reducedCost(i, head, cost) < limit)) return;
    cost.value = std::max(cost.value, power_(costs.lowerBound(i, j)));
    const LevelCost reduced = tree_.reducedCost(i, head, cost);
    if (reduced < limit) bounds_.push_back({reduced, {i, j}});
}

// Keeps some pairs in turn, since a bound may stay below the cost for ever, and pairs of least bounds.
void DynamicTransport::keepBest() {
    const auto before = [](const Bound& a, const Bound& b) {
        if (a.reduced < b.reduced || b.reduced < a.reduced) return a.reduced < b.reduced;
        return a.pair.character != b.pair.character ? a.pair.character < b.pair.character
                                                    : a.pair.place < b.pair.place;
    };
    if (bounds_.size() > kKeptPerScan) {
        const std::size_t best = kKeptPerScan / 2;
        for (std::size_t k = 0; k < kKeptPerScan - best; ++k)
            pairs_.push_back(bounds_[(std::size_t{pass_} + k * bounds_.size() / best) % bounds_.size()].pair);
        std::nth_element(bounds_.begin(), bounds_.begin() + best, bounds_.end(), before);
        bounds_.resize(best);
        std::sort(bounds_.begin(), bounds_.end(), before);
    }
    for (const Bound& bound : bounds_) pairs_.push_back(bound.pair);
    bounds_.clear();
}

// Scans whole rows and columns in turn.
void DynamicTransport::scan(const TransportInput& input, CostOracle& costs) {
    leastUnitCost_ = costs.leastUnitCost();
    const std::int32_t rows = tree_.characters(), columns = tree_.places();
    for (std::int32_t left = std::min(kScannedPairs, 2 * rows * columns); left > 0; left -= rows + columns) {
        ++pass_;
        row_ = row_ + 1 < rows ? row_ + 1 : 0;
        column_ = column_ + 1 < columns ? column_ + 1 : 0;
        for (std::int32_t j = 0; j < columns; ++j) consider(input, costs, row_, j);
        keepBest();
        for (std::int32_t i = 0; i < rows; ++i) consider(input, costs, i, column_);
        keepBest();
    }
}

void DynamicTransport::evaluateCandidates(const TransportInput& input, CostOracle& costs, ThreadPool& pool) {
    pairCosts_.resize(pairs_.size());
    costs.evaluate(pairs_, pairCosts_, pool);
    candidates_.clear();
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const AssignmentPair pair = pairs_[k];
        candidates_.push_back({pair.character,
                               tree_.nodeOfPlace(pair.place),
                               {levelOf(input, pair.character, pair.place), power_(pairCosts_[k])}});
    }
    const LevelCost unsent{TransportTree::kUnsentLevel, 0.0};
    for (std::int32_t i = 0; i < tree_.characters(); ++i)
        if (supply_[i] > 0) candidates_.push_back({i, tree_.root(), unsent});
    for (std::int32_t j = 0; j < tree_.places(); ++j)
        if (demand_[j] > 0) candidates_.push_back({tree_.root(), tree_.nodeOfPlace(j), unsent});
}

// True where one of these candidates entered: that of the least reduced cost.
bool DynamicTransport::exchangeBest(std::size_t first, std::size_t end, std::int64_t& work) {
    LevelCost least{0, -tolerance_};
    const Candidate* best = nullptr;
    for (std::size_t k = first; k < end; ++k) {
        const Candidate& c = candidates_[k];
        const LevelCost reduced = tree_.reducedCost(c.tail, c.head, c.cost);
        if (!(reduced < least)) continue;
        least = reduced;
        best = &c;
    }
    work += static_cast<std::int64_t>(end - first) / 4;
    if (best == nullptr) return false;
    work += tree_.pivot(best->tail, best->head, best->cost);
    ++pivots_;
    return true;
}

// Exchanges block by block, until no candidate is violated.
void DynamicTransport::exchange(std::int64_t budget) {
    pivots_ = 0;
    std::int64_t work = 0;
    const std::size_t count = candidates_.size();
    std::size_t idle = 0;  // Number of candidates since the last pivot.
    for (std::size_t first = 0; count > 0 && idle < count + kBlock && work < budget;) {
        const std::size_t end = std::min(count, first + kBlock);
        idle = exchangeBest(first, end, work) ? 0 : idle + (end - first);
        first = end < count ? end : 0;
    }
}

// Amounts within the rounding of units count as nothing.
void DynamicTransport::publish() {
    flows_.clear();
    const std::int64_t negligible = tree_.root();
    for (std::int32_t v = 0; v < tree_.root(); ++v) {
        Flow flow;
        if (tree_.flow(v) <= negligible || !tree_.pairOf(v, flow.character, flow.place)) continue;
        flow.amount = static_cast<double>(tree_.flow(v)) / unitsPerAmount_;
        flows_.push_back(flow);
    }
    std::sort(flows_.begin(), flows_.end(), [](const Flow& a, const Flow& b) {
        return a.character != b.character ? a.character < b.character : a.place < b.place;
    });
    worst_.assign(tree_.characters(), 0.0);
    for (const Candidate& c : candidates_) {
        const LevelCost reduced = tree_.reducedCost(c.tail, c.head, c.cost);
        if (reduced.level == 0 && c.tail < tree_.characters())
            worst_[c.tail] = std::max(worst_[c.tail], -reduced.value);
    }
    gap_ = 0.0;
    for (std::int32_t i = 0; i < tree_.characters(); ++i)
        gap_ += worst_[i] * static_cast<double>(supply_[i]) / unitsPerAmount_;
    gap_ *= power_.units();
}

void DynamicTransport::plant(const TransportInput& input) {
    const auto isPlaced = [](std::int32_t j) { return j >= 0; };
    if (std::any_of(input.incumbent.begin(), input.incumbent.end(), isPlaced))
        start_.keep(input.incumbent, supply_, demand_, tree_);
    else
        start_.run(input.positions, input.classes, supply_, demand_, tree_);
}

void DynamicTransport::update(const TransportInput& input, CostOracle& costs, ThreadPool& pool,
                              std::int32_t effort) {
    const auto characters = static_cast<std::int32_t>(input.positions.characters.size());
    const auto places = static_cast<std::int32_t>(input.positions.places.size());
    const bool fresh = tree_.characters() != characters || tree_.places() != places;
    if (fresh) tree_.reset(characters, places);
    power_ = CostPower(input.exponent);
    countUnits(input);
    if (fresh) plant(input);
    tree_.balance(supply_, demand_);
    evaluateTree(input, costs, pool);
    ++round_;
    pairs_.clear();
    if (characters > 0 && places > 0) {
        collectNear(input);
        scan(input, costs);
    }
    evaluateCandidates(input, costs, pool);
    exchange(kWork * std::max(1, effort));
    publish();
}

}  // namespace muster
