// The exchange graph: nodes, arcs, duals and costs of a dynamic assignment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/infinite_cost.h"
#include "engine/assignment/transport/dynamic/arc_candidates.h"
#include "engine/assignment/transport/dynamic/assignment_nodes.h"
#include "engine/assignment/transport/dynamic/assignment_step.h"
#include "engine/assignment/transport/dynamic/exchange_arcs.h"
#include "engine/assignment/transport/dynamic/refresh_schedule.h"

namespace muster {

class InitialAssignment;

/// The residual network of an assignment (Ahuja, Magnanti, Orlin 1993, 2.4), with its sources and sinks
/// contracted: a cycle of nodes is an exchange, in which each assignee, or none, moves to the next node. Owns
/// nodes, arcs, duals and costs, and is the only one to change them. A step begins with beginStep(); all
/// later phases require the AssignmentStep that it returns.
class ExchangeGraph {
public:
    /// Number of arc slots of each node.
    static constexpr std::int32_t kArcsPerNode = ExchangeArcs::kArcsPerNode;

    /// Sizes the graph; no character has a node, all arcs are self loops.
    void reset(std::int32_t characters, std::int32_t places);
    /// Assigns characters to the nodes of given places, per character, -1 for none. After reset().
    void assignPlaces(std::span<const std::int32_t> placeOf) { nodes_.assignPlaces(placeOf); }

    /// Brings nodes and matched costs up to date: takes over which characters are present and which places
    /// are usable, gives every present character a node, and evaluates the costs of all assignees to their
    /// places.
    AssignmentStep beginStep(const AssignmentProblem& problem, InitialAssignment& initial);
    /// The step with the dual shift of the present assignees, for another repair.
    AssignmentStep reshifted(const AssignmentStep& step) const { return makeStep(step); }

    /// Chooses the heads of all arcs and evaluates their costs.
    void rebuildArcs(const AssignmentStep& step) { buildArcs(step, 0, count()); }
    /// Chooses the heads of the arcs of the nodes from `first` to before `end`, whose costs were unknown
    /// before, and not wrong.
    void startArcs(const AssignmentStep& step, std::int32_t first, std::int32_t end);
    /// Refreshes the arcs of the nodes that are due and of nodes whose heads are out of date, and once a
    /// round the arcs to invalidated nodes.
    void refreshArcs(const AssignmentStep& step, const RefreshSchedule& schedule);
    /// Replaces the arc that column generation added to `tail`.
    void setGeneratedArc(std::int32_t tail, std::int32_t head, float cost) {
        arcs_.setGeneratedArc(tail, head, cost);
    }
    /// Sorts the arcs by their heads, where heads have changed since it was done last.
    void indexIncomingArcs() { arcs_.indexIncoming(); }
    /// Gives the nodes that beginStep() changed a dual between the bounds that their arcs set.
    void updateChangedDuals();

    /// Moves each assignee of a cycle to the next node, the last one's to the first; `cost` is the cost of
    /// each at its new node [m]. Evaluates the arcs of these nodes.
    void exchange(const AssignmentStep& step, std::span<const std::int32_t> cycle,
                  std::span<const float> cost);
    /// Sets the costs of the arcs along a cycle to `cost`, that of each assignee at the next node [m].
    void setCostsAlong(const AssignmentStep& step, std::span<const std::int32_t> cycle,
                       std::span<const float> cost);

    /// True where `node`'s assignee pays for moving to `head`: it exists, and `head` is a place.
    bool pays(std::int32_t node, std::int32_t head) const {
        return nodes_.assignee(node) >= 0 && nodes_.isPlace(head);
    }
    /// The cost of an arc less the dual shift, where the assignee of `tail` pays `costAtHead` there:
    /// costAtHead - matchedPower(tail) - dualSlope . (position of head - of tail) [units of CostPower].
    double arcCost(const AssignmentStep& step, std::int32_t tail, std::int32_t head,
                   double costAtHead) const {
        const double shift = dot(step.dualSlope, nodes_.position(head, step) - nodes_.position(tail, step));
        return costAtHead - matchedPower_[tail] - shift;
    }
    /// The reduced cost of an arc; negative where the arc is violated.
    double reducedCost(std::int32_t arc) const {
        return reducedCost(ExchangeArcs::tail(arc), arcs_.head(arc), arcs_.cost(arc));
    }
    /// The reduced cost of an arc of this cost between two nodes.
    double reducedCost(std::int32_t tail, std::int32_t head, double cost) const {
        return cost - dual_[head] + dual_[tail];
    }
    /// The least reduced cost of the arcs from a node.
    double leastReducedCost(std::int32_t node) const {
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(node) * kArcsPerNode;
        const std::int32_t* head = arcs_.heads().data() + first;
        const float* cost = arcs_.costs().data() + first;
        double least[2] = {kInfiniteCost, kInfiniteCost};
        for (std::int32_t k = 0; k < kArcsPerNode; k += 2)
            for (std::int32_t m = 0; m < 2; ++m)
                least[m] = std::min(least[m], cost[k + m] - dual_[head[k + m]]);
        // Rounding keeps the order, so the dual of the tail can be added last.
        return std::min(least[0], least[1]) + dual_[node];
    }
    /// The arc of the least reduced cost from a node, the first of several; -1 where none is below infinity.
    std::int32_t mostViolatedArc(std::int32_t node) const;
    /// The common part of the reduced costs of all arcs from a node.
    double tailTerm(const AssignmentStep& step, std::int32_t node) const {
        return dual_[node] - matchedPower_[node] + dot(step.dualSlope, nodes_.position(node, step));
    }
    /// The common part of the reduced costs of all arcs to a node.
    double headTerm(const AssignmentStep& step, std::int32_t node) const {
        return -dual_[node] - dot(step.dualSlope, nodes_.position(node, step));
    }

    const AssignmentNodes& nodes() const { return nodes_; }  ///< The nodes, read only.
    const ExchangeArcs& arcs() const { return arcs_; }       ///< The arcs, read only.
    std::int32_t count() const { return nodes_.count(); }    ///< Number of nodes.
    std::span<const double> duals() const { return dual_; }  ///< Duals per node, less the dual shift.
    std::span<double> duals() { return dual_; }              ///< The duals; any values are valid.
    /// Cost of a node's assignee to its place [m]; 0 where one is missing.
    float matchedCost(std::int32_t node) const { return matchedCost_[node]; }
    std::span<const float> matchedCosts() const { return matchedCost_; }  ///< Matched cost per node [m].
    /// Matched costs to the power of the objective.
    std::span<const double> matchedPowers() const { return matchedPower_; }
    /// Nodes whose matched cost was more than three times the mean at the last refreshArcs(), ascending.
    const std::vector<std::int32_t>& expensiveNodes() const { return candidates_.expensive(); }

    /// True where the node's arcs are not to be repaired yet.
    bool isDelayed(std::int32_t node) const { return retryDelay_[node] > 0; }
    /// Keeps a node's arcs from repair for `steps` steps.
    void delayRetry(std::int32_t node, std::uint8_t steps) { retryDelay_[node] = steps; }
    /// Shortens all delays by a step.
    void countDownDelays() {
        for (std::uint8_t& steps : retryDelay_)
            if (steps > 0) --steps;
    }

    /// Lets an archive read or write all data that influences later steps.
    template <class Archive>
    void visit(Archive& archive) {
        archive(nodes_, arcs_, dual_, headsStale_, retryDelay_, matchedCost_, costAtRefresh_, invalidated_);
        if constexpr (Archive::kReading) {
            if (!consistent()) archive.fail();
            if (archive.ok()) afterReading();
        }
    }

private:
    bool consistent() const;
    void afterReading();
    void reserve();
    AssignmentStep makeStep(const AssignmentProblem& problem) const;
    void updateNodes(const AssignmentProblem& problem, InitialAssignment& initial);
    void invalidateArcs(std::int32_t node);
    void evaluateMatchedCosts(const AssignmentStep& step);
    void setMatchedCost(std::int32_t node, float cost, const CostPower& power);
    bool isUnsteady(const AssignmentStep& step, std::int32_t node) const;
    void buildArcs(const AssignmentStep& step, std::int32_t first, std::int32_t end);
    void refreshAllArcs(const AssignmentStep& step);
    void collectInvalidatedArcs(const RefreshSchedule& schedule);
    double tightMargin(const AssignmentStep& step, std::int32_t node) const;
    void queueArc(std::int32_t arc);
    void queueAllArcs(std::int32_t node);
    void queueTightArcs(std::int32_t node, double margin);
    void clearQueue();
    void evaluateQueue(const AssignmentStep& step);
    void evaluateAllArcs(const AssignmentStep& step, std::span<const std::int32_t> nodes);
    void evaluateTightArcs(const AssignmentStep& step, std::span<const std::int32_t> nodes);
    void evaluateArcs(const AssignmentStep& step, std::span<const std::int32_t> arcs);

    AssignmentNodes nodes_;
    ExchangeArcs arcs_;
    std::vector<double> dual_;              // Duals per node, less the dual shift [units of CostPower].
    std::vector<std::uint8_t> headsStale_;  // Per node: its heads must be chosen again.
    std::vector<std::uint8_t> retryDelay_;  // Per node: steps until it is repaired again.
    std::vector<float> matchedCost_;        // Matched cost per node [m].
    std::vector<float> costAtRefresh_;  // Per node: matchedCost_ when all its arcs were evaluated last [m].
    std::vector<std::uint8_t> invalidated_;  // Per node: arcs to it are to be evaluated in the next round.
    // Follows from the above in each step.
    std::vector<double> matchedPower_;  // Per node: matchedCost_ to the power, 0 where it is not matched.
    // Working memory.
    ArcCandidates candidates_;
    // Nodes that became or ceased to be places, or lost their assignee.
    std::vector<std::int32_t> changedNodes_;
    std::vector<std::int32_t> allArcsNodes_;     // Nodes of which all arcs are evaluated.
    std::vector<std::int32_t> tightArcsNodes_;   // Nodes of which the tight arcs are evaluated.
    std::vector<std::int32_t> invalidatedArcs_;  // Arcs to invalidated nodes.
    std::vector<std::int32_t> cycleAssignees_;   // Assignees of a cycle before the exchange.
    std::vector<std::int32_t> queuedArcs_;       // Arcs to evaluate.
    std::vector<AssignmentPair> pairs_;          // Pairs whose costs the queued arcs need, in order.
    std::vector<float> pairCosts_;               // Their costs [m].
};

}  // namespace muster
