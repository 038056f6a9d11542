// Jonker-Volgenant algorithm for the dense linear assignment problem: "A shortest augmenting path algorithm
// for dense and sparse linear assignment problems", Computing 38, 1987.
#pragma once

#include <cstdint>
#include <vector>

namespace muster {

/// Assigns every row of a cost matrix a column of its own at least total cost: column reduction, reduction
/// transfer, two passes of augmenting row reduction, then a shortest augmenting path for each row left. Owns
/// its working memory.
class JonkerVolgenantSolver {
public:
    /// `cost` is row-major, infinite where a pair is impossible; rows <= columns. Returns false,
    /// with some rows assigned, where not every row can be.
    bool solve(std::int32_t rows, std::int32_t columns, const double* cost);

    /// Column of each row, -1 for none.
    const std::vector<std::int32_t>& columnOf() const { return columnOf_; }
    /// u_i = c_ij - v_j with j the column of row i.
    const std::vector<double>& rowDual() const { return rowDual_; }
    /// v_j <= 0 where rows < columns; 0 where the column is free.
    const std::vector<double>& columnDual() const { return columnDual_; }
    /// Number of searches for a shortest path.
    std::int32_t augmentations() const { return augmentations_; }

private:
    // The two columns of least reduced cost in a row.
    struct TwoLowest {
        double first;
        double second;
        std::int32_t firstColumn;
        std::int32_t secondColumn;
    };
    // A column whose distance is final.
    struct Settled {
        std::int32_t column;
        double distance;
    };

    const double* row(std::int32_t i) const { return cost_ + static_cast<std::size_t>(i) * columns_; }
    void assign(std::int32_t row, std::int32_t column) {
        columnOf_[row] = column;
        rowOf_[column] = row;
    }
    void columnReduction();
    void reductionTransfer();
    TwoLowest twoLowest(std::int32_t row) const;
    void augmentingRowReduction();
    void reduceRow(std::int32_t row, std::int32_t& budget);
    double relax(std::int32_t row, double offset);
    std::int32_t columnAt(double distance) const;
    bool augmentFrom(std::int32_t row);
    void alternate(std::int32_t column, std::int32_t row);

    const double* cost_ = nullptr;
    std::int32_t rows_ = 0;
    std::int32_t columns_ = 0;
    std::int32_t augmentations_ = 0;
    std::vector<std::int32_t> columnOf_;  // Column of each row, -1 for none.
    std::vector<std::int32_t> rowOf_;     // Row of each column, -1 for none.
    std::vector<double> rowDual_;
    std::vector<double> columnDual_;
    std::vector<std::int32_t> freeRows_;      // Rows without a column.
    std::vector<std::int32_t> nextFreeRows_;  // Rows without a column after this pass.
    // This search, per column.
    std::vector<double> openDual_;      // The dual; minus infinity once the column is settled.
    std::vector<double> openDistance_;  // The distance; infinite once the column is settled.
    // The row it was reached from, as wide as a distance for vector code.
    std::vector<std::int64_t> predecessor_;
    std::vector<Settled> settled_;
};

}  // namespace muster
