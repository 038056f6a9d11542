// The flow of a dense transportation problem while augmenting paths are sent (Ford and Fulkerson 1956).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// The amounts that rows send to columns, the rest of the rows, and the paths of the search under way.
struct DenseFlow {
    std::int32_t rows = 0;                        ///< Number of rows.
    std::vector<double> amount;                   ///< Amounts of rows x columns, column-major.
    std::vector<double> remainingSupply;          ///< Remaining supply per row.
    std::vector<double> remainingDemand;          ///< Remaining demand per column.
    std::vector<std::int32_t> rowPredecessor;     ///< Per row: the column it was reached from, -1 for none.
    std::vector<std::int32_t> columnPredecessor;  ///< Per column: the row it was reached from.

    /// Begins without a flow.
    void reset(std::span<const double> supply, std::span<const double> demand);
    /// Amount sent from row to column. Column-major, since searches need the rows that fill a column.
    double& at(std::int32_t row, std::int32_t column) {
        return amount[static_cast<std::size_t>(column) * rows + row];
    }
    double at(std::int32_t row, std::int32_t column) const {  ///< The amount sent from row to column.
        return amount[static_cast<std::size_t>(column) * rows + row];
    }
    /// Sends as much as the path of predecessors from `row` to `column` can carry.
    void augment(std::int32_t row, std::int32_t column);
};

}  // namespace muster
