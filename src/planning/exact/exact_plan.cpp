#include "planning/exact/exact_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::size_t pairIndex(std::int32_t character, std::int32_t place, std::int32_t places) {
    return static_cast<std::size_t>(character) * static_cast<std::size_t>(places) +
           static_cast<std::size_t>(place);
}

}  // namespace

std::unique_ptr<Plan> makeExactPlan() {
    return std::make_unique<ExactPlan>();
}

Status ExactPlan::start(const PlanDef& def, const PlanInput& input) {
    if (Status status = checkPlan(def, input); !status.ok()) return status;
    pending_.freeze(def, input, finished_);
    return {};
}

void ExactPlan::advance(std::int32_t slice, std::int32_t slices, ThreadPool& pool) {
    if (!pending() || slices <= 0 || slice < 0) return;
    const std::int64_t end = static_cast<std::int64_t>(pending_.places()) *
                             (static_cast<std::int64_t>(slice) + 1) / slices;
    pending_.solve(static_cast<std::int32_t>(std::min<std::int64_t>(end, pending_.places())), pool, workers_);
}

Status ExactPlan::finish(ThreadPool& pool, PlanResult& result) {
    if (!pending()) return invalidArgument("no plan is under way");
    pending_.solve(pending_.places(), pool, workers_);
    if (pending_.def().reassign) {
        if (Status status = assign(pool, result); !status.ok()) return status;
    } else {
        keepIncumbents(result);
    }
    std::swap(pending_, finished_);
    pending_.clear();
    return {};
}

void ExactPlan::fillCosts(std::int32_t place) {
    const double exponent = pending_.def().exponent;
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::size_t k = pairIndex(i, place, pending_.places());
        const double c = pending_.pairCost(i, place);
        cost_[k] = c;
        powered_[k] = c < kInfinite ? power(c, exponent) : kInfinite;
    }
}

// What the incumbents still hold: a place that nobody may take or that cannot be reached any more is lost,
// and where several claim more than a place can take, the later ones get what is left.
void ExactPlan::collectIncumbents() {
    left_ = demand_;
    incumbents_.clear();
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::int32_t j = pending_.incumbent(i);
        if (j < 0 || !(cost_[pairIndex(i, j, pending_.places())] < kInfinite)) continue;
        const double amount = std::min(pending_.supplyOf(i), left_[j]);
        if (amount <= 0.0) continue;
        left_[j] -= amount;
        incumbents_.push_back({i, j, amount});
    }
}

// Least longest walk: how long it must be tells which pairs may be used; among matchings of these the least
// sum is chosen.
Status ExactPlan::solveOnce() {
    TransportationProblem problem{pending_.characters(), pending_.places(), powered_, pending_.supply(),
                                  demand_};
    if (pending_.def().bottleneck) {
        const double longest = bottleneck_.solve(problem);
        allowed_ = powered_;
        for (double& c : allowed_)
            if (c > longest) c = kInfinite;
        problem.cost = allowed_;
    }
    return solver_.solve(problem, solution_).within("plan");
}

// Fronts stop where a place is unlikely to find a better character; pairs beyond have a lower bound for a
// cost. An optimum that uses no such pair is the optimum of the true costs, and so is its longest walk. Else
// the fronts concerned go on, and it is sought again.
Status ExactPlan::solveProven(ThreadPool& pool) {
    cost_.resize(static_cast<std::size_t>(pending_.characters()) *
                 static_cast<std::size_t>(pending_.places()));
    powered_.resize(cost_.size());
    for (std::int32_t j = 0; j < pending_.places(); ++j) fillCosts(j);
    for (;;) {
        if (Status status = solveOnce(); !status.ok()) return status;
        unproven_.clear();
        for (const Flow& flow : solution_.flows)
            if (!pending_.met(flow.character, flow.place)) unproven_.push_back(flow.place);
        if (unproven_.empty()) return {};
        std::sort(unproven_.begin(), unproven_.end());
        unproven_.erase(std::unique(unproven_.begin(), unproven_.end()), unproven_.end());
        pending_.widen(unproven_, pool, workers_);
        for (const std::int32_t j : unproven_) fillCosts(j);
    }
}

Status ExactPlan::assign(ThreadPool& pool, PlanResult& result) {
    demand_.clear();
    for (std::int32_t j = 0; j < pending_.places(); ++j) demand_.push_back(pending_.demandOf(j));
    if (Status status = solveProven(pool); !status.ok()) return status;
    collectIncumbents();
    rule_.choose(pending_.def(), pending_.characters(), pending_.places(), powered_, incumbents_,
                 solution_.flows, result.flows);
    report(result);
    result.gapBound = std::max(0.0, result.objective - solution_.cost);
    return {};
}

void ExactPlan::keepIncumbents(PlanResult& result) {
    result.flows.clear();
    cost_.assign(
        static_cast<std::size_t>(pending_.characters()) * static_cast<std::size_t>(pending_.places()),
        kInfinite);
    powered_ = cost_;
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        const std::int32_t j = pending_.incumbent(i);
        if (j < 0 || !pending_.usable(j) || pending_.supplyOf(i) <= 0.0) continue;
        const std::size_t k = pairIndex(i, j, pending_.places());
        cost_[k] = pending_.pairCost(i, j);
        if (cost_[k] < kInfinite) powered_[k] = power(cost_[k], pending_.def().exponent);
        result.flows.push_back({i, j, pending_.supplyOf(i)});
    }
    report(result);
    // Nothing was solved, and costs are at least 0.
    result.gapBound = result.objective;
}

// Costs, objective and changes of the flows written. A character's place is that of its largest flow.
void ExactPlan::report(PlanResult& result) {
    result.cost.assign(pending_.characters(), kInfinite);
    result.objective = 0.0;
    result.reassigned = 0;
    std::size_t k = 0;
    for (std::int32_t i = 0; i < pending_.characters(); ++i) {
        std::int32_t place = -1;
        double most = 0.0;
        for (; k < result.flows.size() && result.flows[k].character == i; ++k) {
            const Flow& flow = result.flows[k];
            const double c = powered_[pairIndex(i, flow.place, pending_.places())];
            if (c < kInfinite) result.objective += c * flow.amount;
            if (flow.amount <= most) continue;
            most = flow.amount;
            place = flow.place;
        }
        if (place >= 0) result.cost[i] = cost_[pairIndex(i, place, pending_.places())];
        if (place != pending_.incumbent(i)) ++result.reassigned;
    }
}

double ExactPlan::costAt(std::int32_t place, Vec2 p) const {
    const CostField* field = finished_.field(place);
    return field == nullptr ? kInfinite : field->cost(p);
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
