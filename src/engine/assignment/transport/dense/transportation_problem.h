// The transportation problem (Hitchcock 1941; SPEC A1, paper eq. 2), solved exactly.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "muster/status.h"

namespace muster {

/// An amount sent from a character to a place: a positive entry of the flow matrix.
struct Flow {
    std::int32_t character = 0;  ///< Index of the row.
    std::int32_t place = 0;      ///< Index of the column.
    double amount = 1.0;         ///< Amount in units of supply, > 0.

    /// Lets an archive read or write the flow.
    template <class Archive>
    void visit(Archive& archive) {
        archive(character, place, amount);
    }
};

/// Supplies, demands and costs. Spans stay valid during the call only.
struct TransportationProblem {
    std::int32_t rows = 0;     ///< Number of characters.
    std::int32_t columns = 0;  ///< Number of places.
    /// Costs of rows x columns, row-major, >= 0; infinite where a pair is impossible.
    std::span<const double> cost;
    std::span<const double> supply;  ///< Supply per row >= 0; empty for 1 each.
    std::span<const double> demand;  ///< Demand per column >= 0; empty for 1 each.
};

/// The optimum, and the duals that prove it.
struct TransportationSolution {
    std::vector<Flow> flows;         ///< Flows, ordered by character, then place.
    double amount = 0.0;             ///< Sum of the flows: the greatest possible.
    double cost = 0.0;               ///< Sum of cost times amount: the least for that sum of flows.
    std::vector<double> rowDual;     ///< u per row: u_i + v_j <= c_ij, equal where something flows.
    std::vector<double> columnDual;  ///< v per column.
    std::int32_t augmentations = 0;  ///< Number of searches for a shortest path.
};

/// Sends as much as possible, and that at least cost. A Dulmage-Mendelsohn decomposition splits the problem
/// into parts in which the scarcer side is used up; equal amounts are an assignment problem, solved by the
/// algorithm of Jonker and Volgenant, other amounts by successive shortest paths
/// (docs/method/transportation.md). Ties fall to the lower index. Owns its working memory.
class TransportationSolver {
public:
    TransportationSolver();  ///< An empty solver.
    ~TransportationSolver();
    TransportationSolver(TransportationSolver&&) noexcept;  ///< Moves the solver.
    TransportationSolver& operator=(TransportationSolver&&) noexcept;

    /// Fails with InvalidArgument where a size does not fit, or a cost, supply or demand is negative or NaN.
    Status solve(const TransportationProblem& problem, TransportationSolution& solution);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
