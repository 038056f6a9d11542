// Assignment over few arcs, with the prices that prove it.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace muster::scale {

/// The cost of a pair that is not possible.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A column that a row may take.
struct Arc {
    std::int32_t column = 0;
    double cost = 0.0;
};

/// Matches every row to a column of its own at least cost: shortest augmenting paths with prices (Jonker and
/// Volgenant 1987, for sparse costs), in its own code and apart from the plans' solvers.
class SparseAssignment {
public:
    /// `rows` lists each row's arcs. `start` are first prices of the columns: any where there are as many
    /// rows as columns, else none (empty). Returns false where not all rows can be matched; prices are of use
    /// even then.
    bool solve(std::span<const std::vector<Arc>> rows, std::int32_t columns, std::span<const double> start);

    const std::vector<std::int32_t>& columnOf() const { return columnOf_; }  ///< Per row; -1 for none.
    /// Prices v of the columns: a column that nobody takes has its first price, others at most that.
    const std::vector<double>& price() const { return price_; }

private:
    struct Entry {
        double distance;
        std::int32_t column;
        // Heaps keep the largest on top.
        bool operator<(const Entry& other) const {
            return distance != other.distance ? distance > other.distance : column > other.column;
        }
    };

    void reduce(std::span<const std::vector<Arc>> rows);
    bool augment(std::span<const std::vector<Arc>> rows, std::int32_t row);
    void relax(std::span<const std::vector<Arc>> rows, std::int32_t row, double from);

    std::vector<std::int32_t> columnOf_;
    std::vector<std::int32_t> rowOf_;
    std::vector<double> price_;
    std::vector<double> distance_;
    std::vector<std::int32_t> before_;  // Row from which a column was reached.
    std::vector<std::uint8_t> settled_;
    std::vector<std::int32_t> touched_;
    std::vector<std::int32_t> order_;  // Settled columns.
    std::vector<Entry> heap_;
    std::vector<std::int32_t> free_;
};

}  // namespace muster::scale
