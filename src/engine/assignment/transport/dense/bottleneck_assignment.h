// Bottleneck assignment by thresholds (Burkard, Dell'Amico, Martello 2009, 6.2), for any amounts.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/assignment/transport/dense/transportation_problem.h"

namespace muster {

/// Finds the least cost T such that the pairs of cost up to T can send as much as all pairs together (the
/// bottleneck transportation problem). A binary search over the costs that occur; for each, a maximum flow by
/// phases of shortest augmenting paths (Hopcroft and Karp 1973, Dinic 1970), which starts from the flow of
/// the largest T that was too small. Owns its working memory.
class BottleneckSolver {
public:
    /// The problem must be one that TransportationSolver accepts. Returns T, 0 where nothing can be sent.
    double solve(const TransportationProblem& problem);

private:
    // The flow from one row to a column, in the column's list.
    struct ColumnEntry {
        std::int32_t row;
        double amount;
        std::int32_t next;  // Index of the next entry, -1 at the end of the list.
    };
    struct FlowState {
        std::vector<double> remainingSupply;  // Remaining supply per row.
        std::vector<double> remainingDemand;  // Remaining demand per column.
        std::vector<std::int32_t> first;      // Per column: its first entry, -1 for none.
        std::vector<ColumnEntry> entries;
        double amount = 0.0;  // Sum of the flow.
    };
    // An arc of a path from a row to a column, and the flow that the path then takes back.
    struct PathArc {
        std::int32_t row;
        std::int32_t column;
        std::int32_t entry;  // The entry of the path's next row, -1 at its end.
    };

    void reset(const TransportationProblem& problem);
    void collectCosts(const TransportationProblem& problem);
    void maximizeFlow(const TransportationProblem& problem, double threshold);
    bool buildLevels(const TransportationProblem& problem, double threshold);
    void reachRowsOf(std::int32_t column, std::int32_t level);
    bool augmentFrom(const TransportationProblem& problem, double threshold, std::int32_t source);
    std::int32_t entryAtLevel(std::int32_t column, std::int32_t level) const;
    void sendAlongPath(std::int32_t source, std::int32_t column);
    void add(std::int32_t row, std::int32_t column, double amount);

    double negligible_ = 0.0;  // Amounts up to this count as nothing.
    FlowState flow_;
    FlowState startFlow_;  // The flow of the largest threshold that was too small.
    std::vector<double> costs_;
    std::vector<std::int32_t> rowLevel_;          // Level of the level graph, -1 outside.
    std::vector<std::int32_t> columnLevel_;       // Level of each column, -1 outside.
    std::vector<std::int32_t> unreachedColumns_;  // Columns that have no level yet.
    std::vector<std::int32_t> queue_;             // Queue of rows.
    std::vector<std::int32_t> nextColumn_;        // Per row: the column to try next in this phase.
    std::vector<PathArc> path_;
};

}  // namespace muster
