// The least longest walk: how dear the dearest pair must be.
#pragma once

#include <cstdint>
#include <vector>

#include "assignment/dense/transportation_problem.h"

namespace muster {

/// Finds the least cost T such that pairs no dearer than T match as much as all pairs together can (the
/// bottleneck of the transportation problem). Owns its working memory.
///
/// A search by halves over the costs that occur; for each, a greatest flow by phases of shortest augmenting
/// paths (as Hopcroft and Karp 1973, Dinic 1970), begun from the flow of the greatest T that was found too
/// small.
class BottleneckSolver {
public:
    /// The problem is one that TransportationSolver takes. 0 where nothing can be matched.
    double solve(const TransportationProblem& problem);

private:
    struct Share {
        std::int32_t row;
        double amount;
        std::int32_t next;  // In the column's list, -1 at its end.
    };
    // What flows, and what is left to flow.
    struct State {
        std::vector<double> supply;
        std::vector<double> demand;
        std::vector<std::int32_t> first;  // Per column: its list.
        std::vector<Share> shares;
        double amount = 0.0;
    };
    struct Turn {
        std::int32_t row;
        std::int32_t column;
        std::int32_t share;  // By which the path goes on to another row.
    };

    void reset(const TransportationProblem& problem);
    void collectCosts(const TransportationProblem& problem);
    void grow(const TransportationProblem& problem, double most);
    bool layer(const TransportationProblem& problem, double most);
    void enter(std::int32_t column, std::int32_t level);
    bool descend(const TransportationProblem& problem, double most, std::int32_t root);
    std::int32_t shareTo(std::int32_t column, std::int32_t level) const;
    void push(std::int32_t root, std::int32_t column);
    void add(std::int32_t row, std::int32_t column, double amount);

    double dust_ = 0.0;
    State state_;
    State kept_;
    std::vector<double> costs_;
    std::vector<std::int32_t> rowLevel_;
    std::vector<std::int32_t> columnLevel_;
    std::vector<std::int32_t> unseen_;  // Columns that no layer holds yet.
    std::vector<std::int32_t> queue_;
    std::vector<std::int32_t> next_;  // Per row: the column to look at.
    std::vector<Turn> path_;
};

}  // namespace muster
