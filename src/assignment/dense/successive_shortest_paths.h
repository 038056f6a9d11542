// Dense transport of any amounts: successive shortest paths with prices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// Sends all that the rows have to columns at least cost. Owns its working memory.
class SuccessiveShortestPaths {
public:
    /// `cost` is row-major, infinite where impossible. Amounts up to `dust` count as nothing. Returns false
    /// (with what could be sent) where not all can be sent.
    bool solve(std::int32_t rows, std::int32_t columns, const double* cost, std::span<const double> supply,
               std::span<const double> demand, double dust);

    /// Amount sent from row to column.
    double flow(std::int32_t row, std::int32_t column) const { return flow_[at(row, column)]; }
    const std::vector<double>& rowDual() const { return rowDual_; }  ///< u; u_i + v_j <= c_ij.
    /// V <= 0; 0 where demand is left.
    const std::vector<double>& columnDual() const { return columnDual_; }
    std::int32_t augmentations() const { return augmentations_; }  ///< Shortest paths searched.

private:
    // Column by column, since the search asks who sends to a column.
    std::size_t at(std::int32_t row, std::int32_t column) const {
        return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) +
               static_cast<std::size_t>(row);
    }
    void reset(std::span<const double> supply, std::span<const double> demand);
    void relax(std::int32_t row);
    std::int32_t nearest() const;
    void enter(std::int32_t column);
    bool augment(std::int32_t from);
    void reprice(double reached);
    void send(std::int32_t from, std::int32_t end);

    const double* cost_ = nullptr;
    std::int32_t rows_ = 0;
    std::int32_t columns_ = 0;
    std::int32_t augmentations_ = 0;
    double dust_ = 0.0;
    std::vector<double> flow_;
    std::vector<double> excess_;  // Left to send, per row.
    std::vector<double> spare_;   // Left to fill, per column.
    std::vector<double> rowDual_;
    std::vector<double> columnDual_;
    std::vector<double> rowDistance_;       // Infinite for rows not entered.
    std::vector<std::int32_t> rowThrough_;  // Column by which the row was entered, -1 for the start.
    std::vector<std::int32_t> entered_;     // Rows, in order of entering.
    std::vector<double> columnDistance_;
    std::vector<std::int32_t> columnThrough_;  // Row by which the column was reached.
    std::vector<std::int32_t> open_;           // Columns not scanned yet.
    std::vector<std::int32_t> scanned_;        // Columns whose distance is final.
};

}  // namespace muster
