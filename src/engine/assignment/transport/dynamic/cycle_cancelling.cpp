#include "engine/assignment/transport/dynamic/cycle_cancelling.h"

#include <algorithm>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr std::uint8_t kLimitReachedDelay = 3;  // Delay after a search that reached its limit [steps].
constexpr std::int32_t kTriesPerNode = 3;       // Number of arcs of one node that are tried in one step.
// Smallest violation that is repaired, in commit thresholds. An exchange of two nodes that gains a threshold
// has an arc that is violated by at least half of it, whatever the duals.
constexpr double kToleranceInThresholds = 0.5;
// The smallest violation for the relative threshold: in shares of the mean matched cost.
constexpr double kToleranceInShares = 0.25;
// Violation, in required gains, from which on an arc was out of date, and is tried again at once.
constexpr double kOutdatedGains = 2.0;

}  // namespace

double CycleCancelling::tolerance(const AssignmentStep& step, const ExchangeGraph& graph) {
    double sum = 0.0;
    for (const double c : graph.matchedPowers()) sum += c;
    const double mean = sum / std::max(1.0, static_cast<double>(graph.count()));
    return std::max({kToleranceInThresholds * step.threshold,
                     kToleranceInShares * step.def.thresholdShare * mean, 1e-9 * mean, 1e-30});
}

void CycleCancelling::reset(std::int32_t nodes, std::int32_t searchLimit) {
    search_.reset(nodes, searchLimit);
    violations_.reserve(nodes);
    cycleCosts_.reserve(nodes + 1);
}

void CycleCancelling::collectViolations(const ExchangeGraph& graph, double tolerance, std::int32_t most) {
    violations_.clear();
    gapBefore_ = 0.0;
    for (std::int32_t node = 0; node < graph.count(); ++node) {
        const double least = graph.leastReducedCost(node);
        gapBefore_ -= std::min(0.0, least);
        if (-least > tolerance && !graph.isDelayed(node))
            violations_.push_back({-least, graph.mostViolatedArc(node)});
    }
    violatedNodes_ = static_cast<std::int32_t>(violations_.size());
    const auto larger = [](const Violation& a, const Violation& b) {
        return a.size != b.size ? a.size > b.size : a.arc < b.arc;
    };
    if (violatedNodes_ > most) {
        std::nth_element(violations_.begin(), violations_.begin() + most, violations_.end(), larger);
        violations_.resize(most);
    }
    std::sort(violations_.begin(), violations_.end(), larger);
}

void CycleCancelling::run(const AssignmentStep& step, ExchangeGraph& graph, std::int64_t budget,
                          std::int32_t retryDelay) {
    retryDelay_ = static_cast<std::uint8_t>(retryDelay);
    exchanges_ = 0;
    settled_ = 0;
    graph.countDownDelays();
    const double smallest = tolerance(step, graph);
    // Each violation takes one node of the budget at least.
    collectViolations(graph, smallest,
                      static_cast<std::int32_t>(std::min<std::int64_t>(budget, graph.count())));
    if (!violations_.empty()) graph.indexIncomingArcs();
    for (const Violation& violation : violations_) {
        if (settled_ >= budget) break;
        repairNode(step, graph, ExchangeArcs::tail(violation.arc), smallest, budget);
    }
}

// The length of the arc from `end` straight back to `start`, which need not be in the graph.
double CycleCancelling::returnArcCost(const AssignmentStep& step, const ExchangeGraph& graph,
                                      std::int32_t start, std::int32_t end) {
    const AssignmentNodes& nodes = graph.nodes();
    const std::int32_t arc = graph.arcs().find(end, start);
    if (arc >= 0) return std::max(graph.reducedCost(arc), 0.0);
    const std::int32_t assignee = nodes.assignee(end);
    // Exchanging with a free dummy node would leave a place without its assignee.
    if (assignee < 0 && !nodes.isPlace(end)) return kInfiniteCost;
    const double costAtStart = graph.pays(end, start) ? step.power(step.costs.cost(assignee, start)) : 0.0;
    return std::max(graph.reducedCost(end, start, graph.arcCost(step, end, start, costAtStart)), 0.0);
}

void CycleCancelling::repairNode(const AssignmentStep& step, ExchangeGraph& graph, std::int32_t node,
                                 double tolerance, std::int64_t budget) {
    for (std::int32_t k = 0; k < kTriesPerNode && settled_ < budget; ++k) {
        const std::int32_t arc = graph.mostViolatedArc(node);
        const double violation = -graph.reducedCost(arc);
        if (!(violation > tolerance)) return;
        const std::int32_t head = graph.arcs().head(arc);
        const auto limit = static_cast<std::int32_t>(
            std::min<std::int64_t>(step.def.searchLimit, budget - settled_));
        const SearchResult result = search_.run(graph.arcs(), graph.duals(), node, head, violation,
                                                returnArcCost(step, graph, node, head), limit);
        settled_ += search_.settled() + 1;
        search_.updateDuals(graph.duals());
        if (result == SearchResult::LimitReached) {
            graph.delayRetry(node, kLimitReachedDelay);
            return;
        }
        if (result != SearchResult::Cycle || commit(step, graph)) continue;
        // A small remaining violation means that the cycle gains less than the threshold. A large one means
        // that arc costs were out of date, and another search may find a better cycle.
        const double remaining = -graph.reducedCost(arc);
        if (remaining > tolerance && remaining < kOutdatedGains * requiredGain_) {
            graph.delayRetry(node, retryDelay_);
            return;
        }
    }
}

void CycleCancelling::evaluateCycle(const AssignmentStep& step, const ExchangeGraph& graph) {
    const auto cycle = search_.cycle();
    cycleCosts_.clear();
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        const std::int32_t head = cycle[(k + 1) % cycle.size()];
        const bool pays = graph.pays(cycle[k], head);
        cycleCosts_.push_back(pays ? step.costs.cost(graph.nodes().assignee(cycle[k]), head) : 0.0f);
    }
}

// Commits the cycle found where it gains enough by today's costs; else takes these over as arc costs.
bool CycleCancelling::commit(const AssignmentStep& step, ExchangeGraph& graph) {
    evaluateCycle(step, graph);
    const auto cycle = search_.cycle();
    double before = 0.0;
    double after = 0.0;
    for (std::size_t k = 0; k < cycle.size(); ++k) {
        before += graph.matchedPowers()[cycle[k]];
        if (graph.pays(cycle[k], cycle[(k + 1) % cycle.size()])) after += step.power(cycleCosts_[k]);
    }
    requiredGain_ = std::max(step.threshold, step.def.thresholdShare * before);
    if (!(before - after > requiredGain_)) {
        graph.setCostsAlong(step, cycle, cycleCosts_);
        return false;
    }
    graph.exchange(step, cycle, cycleCosts_);
    ++exchanges_;
    return true;
}

}  // namespace muster
