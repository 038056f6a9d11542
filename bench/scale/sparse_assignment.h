// Sparse assignment problem by the Jonker-Volgenant algorithm, with optimal duals.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace muster::scale {

/// The cost of a forbidden pair.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A column that a row may be matched to.
struct Arc {
    std::int32_t column = 0;  ///< Index of the column.
    double cost = 0.0;        ///< Cost of the pair.
};

/// Matches every row to a column of its own at least cost: augmenting row reduction and shortest
/// augmenting paths (Jonker and Volgenant 1987). It shares no code with the solvers of plans, which it
/// judges.
class SparseAssignment {
public:
    /// `rows` lists each row's arcs. `start` are initial duals of the columns, which may only be given
    /// where there are as many rows as columns. Returns false where not all rows can be matched; the duals
    /// still give a lower bound then.
    bool solve(std::span<const std::vector<Arc>> rows, std::int32_t columns, std::span<const double> start);

    const std::vector<std::int32_t>& columnOf() const { return columnOf_; }  ///< Per row; -1 for none.
    /// Duals of the columns. An unmatched column has its initial dual, the others have at most that.
    const std::vector<double>& duals() const { return dual_; }

private:
    struct Entry {
        double distance;
        std::int32_t column;
        // Reversed, since std heaps have the largest on top.
        bool operator<(const Entry& other) const {
            return distance != other.distance ? distance > other.distance : column > other.column;
        }
    };

    void reduce(std::span<const std::vector<Arc>> rows);
    bool augment(std::span<const std::vector<Arc>> rows, std::int32_t row);
    void relax(std::span<const std::vector<Arc>> rows, std::int32_t row, double from);

    std::vector<std::int32_t> columnOf_;
    std::vector<std::int32_t> rowOf_;
    std::vector<double> dual_;
    std::vector<double> distance_;
    std::vector<std::int32_t> parentRow_;  // Row from which a column was reached.
    std::vector<std::uint8_t> settled_;
    std::vector<std::int32_t> touched_;
    std::vector<std::int32_t> order_;  // Settled columns.
    std::vector<Entry> heap_;
    std::vector<std::int32_t> free_;
};

}  // namespace muster::scale
