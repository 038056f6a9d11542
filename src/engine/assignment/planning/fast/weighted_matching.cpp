#include "engine/assignment/planning/fast/weighted_matching.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/maths.h"
#include "engine/assignment/planning/fast/place_matching.h"
#include "engine/assignment/planning/main_places.h"

namespace muster {
namespace {

constexpr double kNegligibleFlow = 1e-9;  // Share of an amount that counts as nothing.
constexpr double kMostUnits = 1e9;        // Greatest number of units of a flow in an archive.

bool before(const AssignmentPair& a, const AssignmentPair& b) {
    return a.character != b.character ? a.character < b.character : a.place < b.place;
}

double amountOf(std::span<const double> amounts, std::size_t k) {
    return amounts.empty() ? 1.0 : amounts[k];
}

}  // namespace

// The number of places is not known here; FastPlan tests those of placeOf().
bool WeightedMatching::consistent() const {
    const auto characters = static_cast<std::int32_t>(placeOf_.size());
    if (cost_.size() != placeOf_.size() || flowCost_.size() != flows_.size()) return false;
    const auto bad = [](float cost) { return !(cost >= 0.0f) || !std::isfinite(cost); };
    if (std::any_of(cost_.begin(), cost_.end(), bad)) return false;
    if (std::any_of(flowCost_.begin(), flowCost_.end(), bad)) return false;
    for (const Flow& flow : flows_)
        if (flow.character < 0 || flow.character >= characters || flow.place < 0 || !(flow.amount > 0.0) ||
            flow.amount > kMostUnits)
            return false;
    return !std::isnan(dualityGap_) &&
           std::is_sorted(flows_.begin(), flows_.end(), [](const Flow& a, const Flow& b) {
               return before({a.character, a.place}, {b.character, b.place});
           });
}

// Adds the amount that may still flow.
void WeightedMatching::claim(const MatchingProblem& problem, std::int32_t i, std::int32_t j, double amount) {
    if (i < 0 || j < 0 || std::cmp_greater_equal(i, openSupply_.size()) ||
        std::cmp_greater_equal(j, openDemand_.size()))
        return;
    const double most = std::min({amount, openSupply_[i], openDemand_[j]});
    if (most <= kNegligibleFlow * amountOf(problem.supply, i)) return;
    openSupply_[i] -= most;
    openDemand_[j] -= most;
    incumbents_.push_back({i, j, most});
}

// Collects the flows of the last step where these made the incumbents, else one flow for each incumbent.
// Where supplies or demands have become less, later flows get the rest.
void WeightedMatching::collectIncumbents(const MatchingProblem& problem) {
    const AssignmentInput& input = problem.input;
    openSupply_.clear();
    openDemand_.clear();
    incumbents_.clear();
    for (std::int32_t i = 0; std::cmp_less(i, input.characters.size()); ++i)
        openSupply_.push_back(input.isPresent(i) ? amountOf(problem.supply, i) : 0.0);
    for (std::int32_t j = 0; std::cmp_less(j, input.places.size()); ++j)
        openDemand_.push_back(input.isUsable(j) ? amountOf(problem.demand, j) : 0.0);
    const auto& incumbent = problem.incumbent;
    if (std::equal(placeOf_.begin(), placeOf_.end(), incumbent.begin(), incumbent.end())) {
        for (const Flow& flow : flows_) claim(problem, flow.character, flow.place, flow.amount);
        return;
    }
    for (std::int32_t i = 0; std::cmp_less(i, incumbent.size()); ++i)
        claim(problem, i, incumbent[i], amountOf(problem.supply, i));
}

// Merges and evaluates the pairs of both lists.
void WeightedMatching::evaluatePairs(std::size_t characters, CostOracle& costs, ThreadPool& pool) {
    const std::span<const Flow> a = incumbents_, b = transport_.flows();
    const auto pairOf = [](const Flow& flow) { return AssignmentPair{flow.character, flow.place}; };
    pairs_.clear();
    for (std::size_t k = 0, m = 0; k < a.size() || m < b.size();) {
        const bool first = m == b.size() || (k < a.size() && !before(pairOf(b[m]), pairOf(a[k])));
        const bool both = first && k < a.size() && m < b.size() && !before(pairOf(a[k]), pairOf(b[m]));
        pairs_.push_back(pairOf(first ? a[k] : b[m]));
        k += first ? 1 : 0;
        m += !first || both ? 1 : 0;
    }
    firstPair_.assign(characters + 1, 0);
    for (const AssignmentPair& pair : pairs_) ++firstPair_[pair.character + 1];
    for (std::size_t i = 0; i < characters; ++i) firstPair_[i + 1] += firstPair_[i];
    pairCosts_.resize(pairs_.size());
    costs.evaluate(pairs_, pairCosts_, pool);
}

// The cost of an evaluated pair [m].
float WeightedMatching::costOf(std::int32_t character, std::int32_t place) const {
    std::int32_t k = firstPair_[character];
    while (pairs_[k].place != place) ++k;
    return pairCosts_[k];
}

void WeightedMatching::gatherCosts(std::span<const Flow> flows, std::vector<float>& cost) const {
    cost.clear();
    for (const Flow& flow : flows) cost.push_back(costOf(flow.character, flow.place));
}

double WeightedMatching::sumOf(std::span<const Flow> flows, std::span<const float> cost, double exponent) {
    double sum = 0.0;
    for (std::size_t k = 0; k < flows.size(); ++k) sum += flows[k].amount * power(cost[k], exponent);
    return sum;
}

void WeightedMatching::publish(std::span<const std::int32_t> incumbent) {
    findMainPlaces(flows_, incumbent, placeOf_);
    cost_.assign(incumbent.size(), 0.0f);
    for (std::size_t k = 0; k < flows_.size(); ++k)
        if (placeOf_[flows_[k].character] == flows_[k].place) cost_[flows_[k].character] = flowCost_[k];
}

void WeightedMatching::commit(const MatchingProblem& problem) {
    PlanDef def;
    def.commitThreshold = problem.def.threshold;
    def.commitThresholdShare = problem.def.thresholdShare;
    const AssignmentClasses& classes = problem.classes;
    const auto flowCost = [&](std::int32_t i, std::int32_t j) {
        const bool inClass = classes.character.empty() || classes.character[i] == classes.place[j];
        return FlowCost{power(costOf(i, j), problem.def.exponent), inClass};
    };
    commitRule_.choose(def, static_cast<std::int32_t>(problem.input.characters.size()),
                       static_cast<std::int32_t>(problem.input.places.size()), flowCost, incumbents_,
                       transport_.flows(), flows_);
}

void WeightedMatching::update(const MatchingProblem& problem, CostOracle& costs, ThreadPool& pool,
                              std::int32_t effort) {
    transport_.update({problem.input, problem.supply, problem.demand, problem.classes, problem.def.exponent,
                       problem.incumbent},
                      costs, pool, effort);
    collectIncumbents(problem);
    evaluatePairs(problem.input.characters.size(), costs, pool);
    commit(problem);
    gatherCosts(flows_, flowCost_);
    publish(problem.incumbent);
    gatherCosts(transport_.flows(), optimumCost_);
    const double exponent = problem.def.exponent;
    const double optimum = sumOf(transport_.flows(), optimumCost_, exponent);
    dualityGap_ = std::max(0.0, objective(exponent) - optimum) + transport_.gap();
}

void WeightedMatching::hold(const MatchingProblem& problem, std::span<const float> cost) {
    flows_.clear();
    flowCost_.clear();
    for (std::int32_t i = 0; std::cmp_less(i, problem.incumbent.size()); ++i) {
        const std::int32_t j = problem.incumbent[i];
        const double amount = amountOf(problem.supply, i);
        if (j < 0 || !problem.input.isUsable(j) || !(amount > 0.0)) continue;
        flows_.push_back({i, j, amount});
        flowCost_.push_back(cost[i]);
    }
    publish(problem.incumbent);
    dualityGap_ = objective(problem.def.exponent);
}

}  // namespace muster
