// Cycle cancelling (Klein 1967): commits exchanges that lower the objective.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/bidirectional_dijkstra.h"
#include "engine/assignment/transport/dynamic/exchange_graph.h"

namespace muster {

/// Takes violated arcs, the most violated first. Each is closed to a cycle of negative cost, which is
/// committed if it gains enough by today's costs, or the duals are changed until it is no longer violated.
/// Ends when no arc is violated by more than a tolerance or the budget of settled nodes is used up. Owns its
/// working memory.
class CycleCancelling {
public:
    /// Sizes the working memory.
    void reset(std::int32_t nodes, std::int32_t searchLimit);
    /// Settles at most `budget` nodes. A node whose cycle gained too little is not tried again for
    /// `retryDelay` steps.
    void run(const AssignmentStep& step, ExchangeGraph& graph, std::int64_t budget, std::int32_t retryDelay);

    /// Violation up to which an arc is left alone [units of CostPower].
    static double tolerance(const AssignmentStep& step, const ExchangeGraph& graph);

    std::int32_t exchanges() const { return exchanges_; }  ///< Number of cycles committed by the last run.
    std::int32_t violatedNodes() const {
        return violatedNodes_;
    }  ///< Number of nodes with a violated arc when the last run began.
    std::int64_t settled() const { return settled_; }  ///< Number of nodes settled by the last run.
    /// Upper bound, by the duals, of the possible gain when the last run began [units of CostPower].
    double gapBefore() const { return gapBefore_; }

private:
    struct Violation {
        double size;  // Minus the reduced cost.
        std::int32_t arc;
    };

    void collectViolations(const ExchangeGraph& graph, double tolerance, std::int32_t most);
    void repairNode(const AssignmentStep& step, ExchangeGraph& graph, std::int32_t node, double tolerance,
                    std::int64_t budget);
    static double returnArcCost(const AssignmentStep& step, const ExchangeGraph& graph, std::int32_t start,
                                std::int32_t end);
    bool commit(const AssignmentStep& step, ExchangeGraph& graph);
    void evaluateCycle(const AssignmentStep& step, const ExchangeGraph& graph);

    BidirectionalDijkstra search_;
    std::vector<Violation> violations_;
    std::vector<float> cycleCosts_;  // Per node of the cycle: cost of its assignee at the next node [m].
    double requiredGain_ = 0.0;      // Gain required of the last cycle [units of CostPower].
    std::uint8_t retryDelay_ = 0;    // Delay of a retry [steps].
    std::int32_t exchanges_ = 0;
    std::int32_t violatedNodes_ = 0;
    std::int64_t settled_ = 0;
    double gapBefore_ = 0.0;  // Value of gapBefore() [units of CostPower].
};

}  // namespace muster
