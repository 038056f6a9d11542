#include "engine/assignment/planning/exact/exact_plan.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "base/maths.h"
#include "engine/assignment/planning/assigner.h"
#include "engine/assignment/planning/main_places.h"

namespace muster {

std::unique_ptr<Plan> makeExactPlan() {
    return std::make_unique<ExactPlan>();
}

Status ExactPlan::start(const PlanDef& def, const PlanInput& input) {
    if (Status status = validatePlan(def, input); !status.ok()) return status;
    if (input.costs == nullptr) return invalidArgument("plan has no costs");
    const UnitCost& cost = input.costs->unitCost();
    if (Status status = validateUnitCost(cost); !status.ok()) return status;
    pending_.freeze(def, input, cost, finished_);
    return {};
}

void ExactPlan::advance(std::int32_t share, std::int32_t shares, ThreadPool& pool) {
    if (!pending() || shares <= 0 || share < 0) return;
    const std::int64_t end = static_cast<std::int64_t>(pending_.places()) *
                             (static_cast<std::int64_t>(share) + 1) / shares;
    pending_.solve(static_cast<std::int32_t>(std::min<std::int64_t>(end, pending_.places())), pool, workers_);
}

Status ExactPlan::finish(ThreadPool& pool, PlanResult& result) {
    if (!pending()) return invalidArgument("no plan is under way");
    pending_.solve(pending_.places(), pool, workers_);
    if (pending_.def().reassign) {
        if (Status status = reassign(pool, result); !status.ok()) return status;
    } else {
        keepIncumbents(result);
    }
    std::swap(pending_, finished_);
    pending_.clear();
    return {};
}

void ExactPlan::readCosts(std::int32_t place) {
    const double exponent = pending_.def().exponent;
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::size_t k = pairIndex(i, place);
        const double c = pending_.pairCost(i, place);
        cost_[k] = c;
        powered_[k] = c < kInfiniteCost ? power(c, exponent) : kInfiniteCost;
    }
}

// Any exchange that makes a pair of one class instead of one of two lowers the sum then: it changes at most
// one pair per character and place.
void ExactPlan::separateClasses() {
    double costliest = 0.0;
    for (const double c : powered_)
        if (c < kInfiniteCost) costliest = std::max(costliest, c);
    const double penalty = 1.0 + costliest * (pending_.characters() + pending_.places());
    classed_ = powered_;
    for (std::int32_t i = 0; i < pending_.characters(); ++i)
        for (std::int32_t j = 0; j < pending_.places(); ++j)
            if (!pending_.inClass(i, j)) classed_[pairIndex(i, j)] += penalty;
}

// Collects the incumbents. A place that is not usable or cannot be reached any more is lost. Where several
// characters claim more than a place demands, later ones get the rest.
void ExactPlan::collectIncumbents() {
    unclaimedDemand_ = demand_;
    incumbents_.clear();
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::int32_t j = pending_.incumbent(i);
        if (j < 0 || !(cost_[pairIndex(i, j)] < kInfiniteCost)) continue;
        const double amount = std::min(pending_.supplyOf(i), unclaimedDemand_[j]);
        if (amount <= 0.0) continue;
        unclaimedDemand_[j] -= amount;
        incumbents_.push_back({i, j, amount});
    }
}

// With the bottleneck objective, pairs costlier than the bottleneck are forbidden, and the least sum is found
// among the others.
Status ExactPlan::solveAssignment() {
    if (pending_.hasClasses()) separateClasses();
    const std::vector<double>& costs = pending_.hasClasses() ? classed_ : powered_;
    TransportationProblem problem{pending_.characters(), pending_.places(), costs, pending_.supply(),
                                  demand_};
    if (pending_.def().bottleneck) {
        const double bottleneck = bottleneck_.solve(problem);
        allowed_ = costs;
        for (double& c : allowed_)
            if (c > bottleneck) c = kInfiniteCost;
        problem.cost = allowed_;
    }
    return solver_.solve(problem, solution_).within("plan");
}

// Fronts are limited, so that only a lower bound of some pairs' costs is known. An optimum that uses no such
// pair is the optimum of the true costs, and so is its bottleneck. Otherwise the fronts concerned are
// extended and the problem is solved again.
Status ExactPlan::solveProvenAssignment(ThreadPool& pool) {
    cost_.resize(pairIndex(pending_.characters(), 0));
    powered_.resize(cost_.size());
    for (std::int32_t j = 0; j < pending_.places(); ++j) readCosts(j);
    for (;;) {
        if (Status status = solveAssignment(); !status.ok()) return status;
        unproven_.clear();
        for (const Flow& flow : solution_.flows)
            if (!pending_.isTarget(flow.character, flow.place)) unproven_.push_back(flow.place);
        if (unproven_.empty()) return {};
        std::sort(unproven_.begin(), unproven_.end());
        unproven_.erase(std::unique(unproven_.begin(), unproven_.end()), unproven_.end());
        pending_.solveUnlimited(unproven_, pool, workers_);
        for (const std::int32_t j : unproven_) readCosts(j);
    }
}

Status ExactPlan::reassign(ThreadPool& pool, PlanResult& result) {
    demand_.clear();
    for (std::int32_t j = 0; j < pending_.places(); ++j) demand_.push_back(pending_.demandOf(j));
    if (Status status = solveProvenAssignment(pool); !status.ok()) return status;
    collectIncumbents();
    const auto costOf = [this](std::int32_t i, std::int32_t j) {
        return FlowCost{powered_[pairIndex(i, j)], pending_.inClass(i, j)};
    };
    commitRule_.choose(pending_.def(), pending_.characters(), pending_.places(), costOf, incumbents_,
                       solution_.flows, result.flows);
    report(result);
    double optimum = solution_.cost;
    if (pending_.hasClasses()) {
        optimum = 0.0;
        for (const Flow& flow : solution_.flows)
            optimum += flow.amount * costOf(flow.character, flow.place).cost;
    }
    result.gapBound = std::max(0.0, result.objective - optimum);
    return {};
}

void ExactPlan::keepIncumbents(PlanResult& result) {
    result.flows.clear();
    cost_.assign(pairIndex(pending_.characters(), 0), kInfiniteCost);
    powered_ = cost_;
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::int32_t j = pending_.incumbent(i);
        if (j < 0 || !pending_.usable(j) || pending_.supplyOf(i) <= 0.0) continue;
        const std::size_t k = pairIndex(i, j);
        cost_[k] = pending_.pairCost(i, j);
        if (cost_[k] < kInfiniteCost) powered_[k] = power(cost_[k], pending_.def().exponent);
        result.flows.push_back({i, j, pending_.supplyOf(i)});
    }
    report(result);
    // No problem was solved; 0 is a lower bound, since costs are not negative.
    result.gapBound = result.objective;
}

// Writes the costs, objective and number of reassigned characters of the committed flows.
void ExactPlan::report(PlanResult& result) {
    result.cost.assign(pending_.characters(), kInfiniteCost);
    result.objective = 0.0;
    result.provisional = result.first = false;
    result.reassigned = 0;
    for (const Flow& flow : result.flows) {
        const double c = powered_[pairIndex(flow.character, flow.place)];
        if (c < kInfiniteCost) result.objective += c * flow.amount;
    }
    findMainPlaces(result.flows, pending_.incumbents(), mainPlace_);
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::int32_t place = mainPlace_[i];
        if (place >= 0) result.cost[i] = cost_[pairIndex(i, place)];
        if (place != pending_.incumbent(i)) ++result.reassigned;
    }
}

double ExactPlan::costAt(std::int32_t place, Vec2 p) const {
    const CostField* field = finished_.field(place);
    return field == nullptr ? kInfiniteCost : field->cost(p);
}

void ExactPlan::save(Writer& archive) const {
    finished_.save(archive);
    pending_.save(archive);
}

bool ExactPlan::load(Reader& archive, ThreadPool& pool) {
    std::int32_t finishedProgress = 0;
    std::int32_t pendingProgress = 0;
    if (!finished_.load(archive, finishedProgress) || !pending_.load(archive, pendingProgress)) {
        finished_.clear();
        pending_.clear();
        return false;
    }
    if (finished_.valid()) finished_.solve(finishedProgress, pool, workers_);
    if (pending_.valid()) pending_.solve(pendingProgress, pool, workers_);
    return true;
}

void ExactPlan::hash(Hasher& archive) const {
    finished_.hash(archive);
    pending_.hash(archive);
}

}  // namespace muster
