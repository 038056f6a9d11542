// Successive shortest paths for dense transportation problems (Ahuja, Magnanti, Orlin 1993, 9.7).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dense/dense_flow.h"

namespace muster {

/// Sends all that the rows supply to columns at least cost: for each row a Dijkstra search on reduced costs,
/// which may go back from a full column to any row that fills it, until the row is empty. Owns its working
/// memory.
class SuccessiveShortestPaths {
public:
    /// `cost` is row-major, infinite where a pair is impossible. Amounts up to `negligible` count as nothing.
    /// Returns false, with the greatest possible flow, where not all can be sent.
    bool solve(std::int32_t rows, std::int32_t columns, const double* cost, std::span<const double> supply,
               std::span<const double> demand, double negligible);

    /// Amount sent from row to column.
    double flow(std::int32_t row, std::int32_t column) const { return flow_.at(row, column); }
    const std::vector<double>& rowDual() const { return rowDual_; }  ///< u; u_i + v_j <= c_ij.
    /// v <= 0; 0 where demand is left.
    const std::vector<double>& columnDual() const { return columnDual_; }
    /// Number of searches for a shortest path.
    std::int32_t augmentations() const { return augmentations_; }

private:
    const double* row(std::int32_t i) const { return cost_ + static_cast<std::size_t>(i) * columns_; }
    void reset(std::span<const double> supply, std::span<const double> demand);
    void relax(std::int32_t row);
    std::int32_t nearestOpenColumn() const;
    void reachRowsOf(std::int32_t column);
    bool sendFrom(std::int32_t row);
    void updateDuals(double distance);

    const double* cost_ = nullptr;
    std::int32_t rows_ = 0;
    std::int32_t columns_ = 0;
    std::int32_t augmentations_ = 0;
    double negligible_ = 0.0;
    DenseFlow flow_;
    std::vector<double> rowDual_;
    std::vector<double> columnDual_;
    std::vector<double> rowDistance_;        // Distance of each row, infinite for rows that are not reached.
    std::vector<std::int32_t> reachedRows_;  // Rows in the order in which they were reached.
    std::vector<double> columnDistance_;
    std::vector<std::int32_t> openColumns_;     // Columns that are not settled yet.
    std::vector<std::int32_t> settledColumns_;  // Columns whose distance is final.
};

}  // namespace muster
