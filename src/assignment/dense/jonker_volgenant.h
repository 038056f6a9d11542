// Dense matching of single units: shortest augmenting paths after Jonker and Volgenant (1987).
#pragma once

#include <cstdint>
#include <vector>

namespace muster {

/// Matches every row of a dense matrix with a column of its own at least total cost. Owns its working memory.
class JonkerVolgenantSolver {
public:
    /// `cost` is row-major, infinite where a pair is impossible; rows <= columns. Returns false (with the
    /// rows matched so far) where not every row can be matched.
    bool solve(std::int32_t rows, std::int32_t columns, const double* cost);

    const std::vector<std::int32_t>& columnOf() const { return columnOf_; }  ///< Per row; -1 for none.
    /// U_i = c_ij - v_j of its pair.
    const std::vector<double>& rowDual() const { return rowDual_; }
    /// V_j <= 0 for rows < columns; 0 where unmatched.
    const std::vector<double>& columnDual() const { return columnDual_; }
    std::int32_t augmentations() const { return augmentations_; }  ///< Shortest paths searched.

private:
    struct TwoLowest {
        double first;
        double second;
        std::int32_t firstColumn;
        std::int32_t secondColumn;
    };

    struct Scanned {
        std::int32_t column;
        double distance;  // Final.
    };

    const double* row(std::int32_t i) const {
        return cost_ + static_cast<std::size_t>(i) * static_cast<std::size_t>(columns_);
    }
    void pair(std::int32_t i, std::int32_t j);
    void reduceColumns();
    void transferReduction();
    TwoLowest twoLowest(std::int32_t i) const;
    void reduceRows();
    void reduceRow(std::int32_t i, std::int32_t& budget);
    double relax(std::int32_t i, double offset);
    std::int32_t pick(double reached) const;
    bool augment(std::int32_t from);
    void flip(std::int32_t end, std::int32_t from);

    const double* cost_ = nullptr;
    std::int32_t rows_ = 0;
    std::int32_t columns_ = 0;
    std::int32_t augmentations_ = 0;
    std::vector<std::int32_t> columnOf_;
    std::vector<std::int32_t> rowOf_;
    std::vector<double> rowDual_;
    std::vector<double> columnDual_;
    std::vector<std::int32_t> free_;  // Rows without a column.
    std::vector<std::int32_t> freeNext_;
    // The search under way, per column: price and distance while open, and the row by which it was reached.
    std::vector<double> openPrice_;
    std::vector<double> openDistance_;
    std::vector<std::int64_t> through_;  // As wide as a distance, for the vector code.
    std::vector<Scanned> scanned_;
};

}  // namespace muster
