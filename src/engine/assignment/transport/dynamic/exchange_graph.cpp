#include "engine/assignment/transport/dynamic/exchange_graph.h"

#include <cmath>

#include "base/infinite_cost.h"
#include "engine/assignment/transport/dynamic/initial_assignment.h"

namespace muster {
namespace {

constexpr std::int32_t kNodesPerBatch = 256;
constexpr std::int32_t kArcsPerBatch = kNodesPerBatch * ExchangeGraph::kArcsPerNode;
constexpr std::size_t kPairsPerBatch = 4096;
// Cost above which the change that invalidates arcs grows with the cost [m].
constexpr double kInvalidatingCost = 4.0;
// Distance that an assignee would have to come nearer for its arc to be violated, up to which the arc is
// tight [m].
constexpr double kTightDistance = 0.2;
// Least matched cost at which the margin of tight arcs is taken [m].
constexpr double kLeastTightCost = 1.0;

}  // namespace

void ExchangeGraph::reset(std::int32_t characters, std::int32_t places) {
    nodes_.reset(characters, places);
    const std::int32_t n = nodes_.count();
    arcs_.reset(n);
    dual_.assign(n, 0.0);
    headsStale_.assign(n, 1);
    retryDelay_.assign(n, 0);
    matchedCost_.assign(n, 0.0f);
    costAtRefresh_.assign(n, 0.0f);
    invalidated_.assign(n, 0);
    matchedPower_.assign(n, 0.0);
    reserve();
}

void ExchangeGraph::reserve() {
    const std::int32_t n = nodes_.count();
    candidates_.reserve(n);
    changedNodes_.reserve(2 * n);
    allArcsNodes_.reserve(n);
    tightArcsNodes_.reserve(n);
    invalidatedArcs_.reserve(arcs_.heads().size());
    cycleAssignees_.reserve(n + 1);
    queuedArcs_.reserve(std::min<std::size_t>(kArcsPerBatch, arcs_.heads().size()));
    const std::size_t pairs = std::min(kPairsPerBatch, arcs_.heads().size());
    pairs_.reserve(pairs);
    pairCosts_.reserve(pairs);
}

bool ExchangeGraph::consistent() const {
    const std::size_t n = nodes_.count();
    return arcs_.heads().size() == n * kArcsPerNode && dual_.size() == n && headsStale_.size() == n &&
           retryDelay_.size() == n && matchedCost_.size() == n && costAtRefresh_.size() == n &&
           invalidated_.size() == n;
}

// The powers of the matched costs follow in the next beginStep().
void ExchangeGraph::afterReading() {
    matchedPower_.assign(nodes_.count(), 0.0);
    arcs_.afterReading();
    arcs_.indexIncoming();
    reserve();
}

AssignmentStep ExchangeGraph::beginStep(const AssignmentProblem& problem, InitialAssignment& initial) {
    updateNodes(problem, initial);
    const AssignmentStep step = makeStep(problem);
    evaluateMatchedCosts(step);
    return step;
}

void ExchangeGraph::updateNodes(const AssignmentProblem& problem, InitialAssignment& initial) {
    changedNodes_.clear();
    nodes_.update(problem.input, changedNodes_);
    for (const std::int32_t node : changedNodes_) invalidateArcs(node);
    for (const std::int32_t node : nodes_.freePlaces()) headsStale_[node] = 1;
    for (const std::int32_t i : nodes_.unmatched())
        if (nodes_.nodeOf(i) >= 0) headsStale_[nodes_.nodeOf(i)] = 1;
    initial.run(problem, nodes_);
    nodes_.assignDummyNodes();
}

// With the exponent 2 and straight distances, moving the formation by t changes |x - y|^2 by a function of x
// plus 2 y . t, and the mean vector d from characters to places by t. So duals less 2 d . position stay as
// they are. For other exponents and costs the shift takes away most of the change.
AssignmentStep ExchangeGraph::makeStep(const AssignmentProblem& problem) const {
    const CostPower costPower(problem.def.exponent);
    const AssignmentInput& input = problem.input;
    Vec2 placeSum;
    Vec2 away;
    std::int32_t places = 0;
    std::int32_t matched = 0;
    for (std::int32_t node = 0; node < nodes_.count(); ++node) {
        if (!nodes_.isPlace(node)) continue;
        const Vec2 place = input.places[node];
        placeSum += place;
        ++places;
        if (nodes_.assignee(node) < 0) continue;
        away += place - input.characters[nodes_.assignee(node)];
        ++matched;
    }
    away = away / std::max(1, matched);
    const double p = costPower.exponent();
    double factor = p;
    if (p != 2.0) {
        double variance = 0.0;
        for (std::int32_t node = 0; node < nodes_.count(); ++node)
            if (nodes_.isMatched(node))
                variance += lengthSquared(input.places[node] - input.characters[nodes_.assignee(node)] -
                                          away);
        const double reach = std::sqrt(lengthSquared(away) + variance / std::max(1, matched)) + 1e-3;
        factor = p * costPower(reach) / (reach * reach);
    }
    return {problem, costPower, away * factor, placeSum / std::max(1, places)};
}

void ExchangeGraph::evaluateMatchedCosts(const AssignmentStep& step) {
    for (std::int32_t node = 0; node < nodes_.count();) {
        pairs_.clear();
        const std::int32_t first = node;
        for (; node < nodes_.count() && pairs_.size() < kPairsPerBatch; ++node)
            if (nodes_.isMatched(node)) pairs_.push_back({nodes_.assignee(node), node});
        pairCosts_.resize(pairs_.size());
        step.costs.evaluate(pairs_, pairCosts_, step.pool);
        std::int32_t next = 0;
        for (std::int32_t n = first; n < node; ++n) {
            const float cost = nodes_.isMatched(n) ? pairCosts_[next++] : 0.0f;
            const double limit = step.def.invalidatingChange *
                                 std::max(1.0, static_cast<double>(cost) / kInvalidatingCost);
            if (std::abs(cost - costAtRefresh_[n]) > limit) invalidateArcs(n);
            setMatchedCost(n, cost, step.power);
        }
    }
}

void ExchangeGraph::setMatchedCost(std::int32_t node, float cost, const CostPower& power) {
    matchedCost_[node] = cost;
    matchedPower_[node] = nodes_.isMatched(node) ? power(cost) : 0.0;
}

// The costs of all arcs from and to the node are wrong, for instance since its place passed over a wall.
void ExchangeGraph::invalidateArcs(std::int32_t node) {
    headsStale_[node] = 1;
    invalidated_[node] = 1;
}

void ExchangeGraph::buildArcs(const AssignmentStep& step, std::int32_t first, std::int32_t end) {
    candidates_.prepare(step, nodes_, dual_, matchedCost_);
    allArcsNodes_.clear();
    for (std::int32_t node = first; node < end; ++node) {
        candidates_.chooseHeads(step, nodes_, matchedCost_, node, arcs_);
        headsStale_[node] = 0;
        allArcsNodes_.push_back(node);
    }
    refreshAllArcs(step);
}

void ExchangeGraph::startArcs(const AssignmentStep& step, std::int32_t first, std::int32_t end) {
    buildArcs(step, first, end);
    std::fill(invalidated_.begin() + first, invalidated_.begin() + end, std::uint8_t{0});
}

void ExchangeGraph::refreshAllArcs(const AssignmentStep& step) {
    evaluateAllArcs(step, allArcsNodes_);
    for (const std::int32_t node : allArcsNodes_) costAtRefresh_[node] = matchedCost_[node];
}

void ExchangeGraph::refreshArcs(const AssignmentStep& step, const RefreshSchedule& schedule) {
    candidates_.prepare(step, nodes_, dual_, matchedCost_);
    collectInvalidatedArcs(schedule);
    allArcsNodes_.clear();
    tightArcsNodes_.clear();
    for (std::int32_t node = 0; node < nodes_.count(); ++node) {
        const bool heads = headsStale_[node] != 0 || schedule.headsDue(node);
        if (!heads && !schedule.costsDue(node)) continue;
        if (heads) candidates_.chooseHeads(step, nodes_, matchedCost_, node, arcs_);
        headsStale_[node] = 0;
        const bool allArcs = heads || schedule.allArcsDue(node) || isUnsteady(step, node);
        (allArcs ? allArcsNodes_ : tightArcsNodes_).push_back(node);
    }
    refreshAllArcs(step);
    evaluateTightArcs(step, tightArcsNodes_);
    evaluateArcs(step, invalidatedArcs_);
}

// Lists the arcs to invalidated nodes, once a round, before any heads change.
void ExchangeGraph::collectInvalidatedArcs(const RefreshSchedule& schedule) {
    invalidatedArcs_.clear();
    if (!schedule.beginsRound) return;
    arcs_.indexIncoming();
    for (std::int32_t node = 0; node < nodes_.count(); ++node) {
        if (invalidated_[node] == 0) continue;
        invalidated_[node] = 0;
        const auto arcs = arcs_.incoming(node);
        invalidatedArcs_.insert(invalidatedArcs_.end(), arcs.begin(), arcs.end());
    }
}

bool ExchangeGraph::isUnsteady(const AssignmentStep& step, std::int32_t node) const {
    return nodes_.isMatched(node) && step.costs.unsteady(nodes_.assignee(node), node);
}

// The reduced cost below which an arc is tight.
double ExchangeGraph::tightMargin(const AssignmentStep& step, std::int32_t node) const {
    const double cost = std::max(static_cast<double>(matchedCost_[node]), kLeastTightCost);
    return step.power(cost + kTightDistance) - step.power(cost);
}

void ExchangeGraph::clearQueue() {
    queuedArcs_.clear();
    pairs_.clear();
}

inline void ExchangeGraph::queueArc(std::int32_t arc) {
    const std::int32_t tail = ExchangeArcs::tail(arc);
    queuedArcs_.push_back(arc);
    if (pays(tail, arcs_.head(arc))) pairs_.push_back({nodes_.assignee(tail), arcs_.head(arc)});
}

void ExchangeGraph::queueAllArcs(std::int32_t node) {
    for (std::int32_t arc = node * kArcsPerNode; arc < (node + 1) * kArcsPerNode; ++arc) {
        if (arcs_.head(arc) == node)
            arcs_.setCost(arc, ExchangeArcs::kSelfLoopCost);
        else
            queueArc(arc);
    }
}

void ExchangeGraph::queueTightArcs(std::int32_t node, double margin) {
    for (std::int32_t arc = node * kArcsPerNode; arc < (node + 1) * kArcsPerNode; ++arc) {
        const std::int32_t head = arcs_.head(arc);
        if (head == node)
            arcs_.setCost(arc, ExchangeArcs::kSelfLoopCost);
        else if (reducedCost(node, head, arcs_.cost(arc)) < margin)
            queueArc(arc);
    }
}

void ExchangeGraph::evaluateQueue(const AssignmentStep& step) {
    pairCosts_.resize(pairs_.size());
    step.costs.evaluate(pairs_, pairCosts_, step.pool);
    std::size_t next = 0;
    for (const std::int32_t arc : queuedArcs_) {
        const std::int32_t tail = ExchangeArcs::tail(arc);
        const std::int32_t head = arcs_.head(arc);
        const double costAtHead = pays(tail, head) ? step.power(pairCosts_[next++]) : 0.0;
        arcs_.setCost(arc, static_cast<float>(arcCost(step, tail, head, costAtHead)));
    }
}

void ExchangeGraph::evaluateAllArcs(const AssignmentStep& step, std::span<const std::int32_t> nodes) {
    while (!nodes.empty()) {
        const auto batch = nodes.first(std::min<std::size_t>(nodes.size(), kNodesPerBatch));
        clearQueue();
        for (const std::int32_t node : batch) queueAllArcs(node);
        evaluateQueue(step);
        nodes = nodes.subspan(batch.size());
    }
}

void ExchangeGraph::evaluateTightArcs(const AssignmentStep& step, std::span<const std::int32_t> nodes) {
    while (!nodes.empty()) {
        const auto batch = nodes.first(std::min<std::size_t>(nodes.size(), kNodesPerBatch));
        clearQueue();
        for (const std::int32_t node : batch) queueTightArcs(node, tightMargin(step, node));
        evaluateQueue(step);
        nodes = nodes.subspan(batch.size());
    }
}

void ExchangeGraph::evaluateArcs(const AssignmentStep& step, std::span<const std::int32_t> arcs) {
    while (!arcs.empty()) {
        const auto batch = arcs.first(std::min<std::size_t>(arcs.size(), kArcsPerBatch));
        clearQueue();
        for (const std::int32_t arc : batch)
            if (arcs_.head(arc) != ExchangeArcs::tail(arc)) queueArc(arc);
        evaluateQueue(step);
        arcs = arcs.subspan(batch.size());
    }
}

// Complementary slackness bounds a node's dual from below by the saving of its assignee elsewhere, and from
// above by the saving of others there.
void ExchangeGraph::updateChangedDuals() {
    if (!changedNodes_.empty()) arcs_.indexIncoming();
    for (const std::int32_t node : changedNodes_) {
        double low = -kInfiniteCost;
        double high = kInfiniteCost;
        for (std::int32_t arc = node * kArcsPerNode; arc < (node + 1) * kArcsPerNode; ++arc) {
            const std::int32_t head = arcs_.head(arc);
            if (head != node) low = std::max(low, dual_[head] - arcs_.cost(arc));
        }
        for (const std::int32_t arc : arcs_.incoming(node)) {
            const std::int32_t tail = ExchangeArcs::tail(arc);
            if (tail != node) high = std::min(high, dual_[tail] + arcs_.cost(arc));
        }
        double& dual = dual_[node];
        if (std::isfinite(low) && std::isfinite(high))
            dual = low < high ? std::clamp(dual, low, high) : 0.5 * (low + high);
        else if (std::isfinite(low))
            dual = low;
        else if (std::isfinite(high))
            dual = high;
    }
}

std::int32_t ExchangeGraph::mostViolatedArc(std::int32_t node) const {
    const std::int32_t first = node * kArcsPerNode;
    const std::int32_t* head = arcs_.heads().data() + first;
    const float* cost = arcs_.costs().data() + first;
    double least = kInfiniteCost;
    std::int32_t worst = -1;
    for (std::int32_t k = 0; k < kArcsPerNode; ++k) {
        const double reduced = reducedCost(node, head[k], cost[k]);
        if (!(reduced < least)) continue;
        least = reduced;
        worst = first + k;
    }
    return worst;
}

void ExchangeGraph::exchange(const AssignmentStep& step, std::span<const std::int32_t> cycle,
                             std::span<const float> cost) {
    cycleAssignees_.clear();
    for (const std::int32_t node : cycle) cycleAssignees_.push_back(nodes_.assignee(node));
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t head = cycle[(k + 1) % cycle.size()];
        nodes_.assign(head, cycleAssignees_[k]);
        setMatchedCost(head, cost[k], step.power);
        headsStale_[head] = 1;
        retryDelay_[head] = 0;
    }
    evaluateAllArcs(step, cycle);
}

void ExchangeGraph::setCostsAlong(const AssignmentStep& step, std::span<const std::int32_t> cycle,
                                  std::span<const float> cost) {
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t head = cycle[(k + 1) % cycle.size()];
        const std::int32_t arc = arcs_.find(cycle[k], head);
        if (arc < 0) continue;
        const double costAtHead = pays(cycle[k], head) ? step.power(cost[k]) : 0.0;
        arcs_.setCost(arc, static_cast<float>(arcCost(step, cycle[k], head, costAtHead)));
    }
}

}  // namespace muster
