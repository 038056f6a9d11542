// The transportation problem (SPEC A1, paper eq. 2).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "muster/status.h"

namespace muster {

/// An amount sent from a character to a place.
struct Flow {
    std::int32_t character = 0;  ///< Row.
    std::int32_t place = 0;      ///< Column.
    double amount = 1.0;         ///< > 0

    /// Lets an archive read or write the flow.
    template <class Archive>
    void visit(Archive& archive) {
        archive(character, place, amount);
    }
};

/// Supplies, demands and costs.
struct TransportationProblem {
    std::int32_t rows = 0;           ///< Characters.
    std::int32_t columns = 0;        ///< Places.
    std::span<const double> cost;    ///< rows x columns, row-major, >= 0; infinite where impossible.
    std::span<const double> supply;  ///< Per row >= 0; empty for 1 each.
    std::span<const double> demand;  ///< Per column >= 0; empty for 1 each.
};

/// The optimum with its proof.
struct TransportationSolution {
    std::vector<Flow> flows;         ///< Ordered by character, then place.
    double amount = 0.0;             ///< Sum of flows: as much as can be matched.
    double cost = 0.0;               ///< Sum of cost times flow: the least for that amount.
    std::vector<double> rowDual;     ///< Dual u; u_i + v_j <= c_ij, equal where flow runs.
    std::vector<double> columnDual;  ///< Dual v.
    std::int32_t augmentations = 0;  ///< Shortest paths searched.
};

/// Matches as much as possible first, then at least cost (successive shortest augmenting paths with
/// prices; for unit weights that is the algorithm of Jonker and Volgenant 1987). Ties fall to the lower
/// index. Owns its working memory.
class TransportationSolver {
public:
    TransportationSolver();  ///< Empty.
    ~TransportationSolver();
    TransportationSolver(TransportationSolver&&) noexcept;  ///< Moves.
    TransportationSolver& operator=(TransportationSolver&&) noexcept;

    /// Fails with InvalidArgument where a size does not fit, or a cost, supply or demand is negative or NaN.
    Status solve(const TransportationProblem& problem, TransportationSolution& solution);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
