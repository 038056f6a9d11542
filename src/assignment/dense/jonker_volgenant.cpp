#include "assignment/dense/jonker_volgenant.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

void JonkerVolgenantSolver::pair(std::int32_t i, std::int32_t j) {
    columnOf_[i] = j;
    rowOf_[j] = i;
}

bool JonkerVolgenantSolver::solve(std::int32_t rows, std::int32_t columns, const double* cost) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    augmentations_ = 0;
    columnOf_.assign(rows, -1);
    rowOf_.assign(columns, -1);
    rowDual_.assign(rows, 0.0);
    columnDual_.assign(columns, 0.0);
    through_.assign(columns, -1);
    // Lowering the price of a column that ends unmatched would be wrong, so columns are reduced
    // only where all of them end matched.
    if (rows == columns) {
        reduceColumns();
        transferReduction();
    }
    free_.clear();
    for (std::int32_t i = 0; i < rows_; ++i)
        if (columnOf_[i] < 0) free_.push_back(i);
    reduceRows();
    reduceRows();
    bool complete = true;
    std::sort(free_.begin(), free_.end());
    for (const std::int32_t i : free_) complete = augment(i) && complete;
    for (std::int32_t i = 0; i < rows_; ++i)
        if (columnOf_[i] >= 0) rowDual_[i] = row(i)[columnOf_[i]] - columnDual_[columnOf_[i]];
    return complete;
}

// Prices each column at its least cost, and lets each row take the first free column that is tight.
void JonkerVolgenantSolver::reduceColumns() {
    columnDual_.assign(columns_, kInfinite);
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = row(i);
        for (std::int32_t j = 0; j < columns_; ++j) columnDual_[j] = std::min(columnDual_[j], c[j]);
    }
    for (double& price : columnDual_)
        if (price == kInfinite) price = 0.0;
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = row(i);
        for (std::int32_t j = 0; j < columns_; ++j) {
            if (c[j] != columnDual_[j] || rowOf_[j] >= 0) continue;
            pair(i, j);
            break;
        }
    }
}

// Lowers the price of a matched column to where its row becomes indifferent to its second choice.
void JonkerVolgenantSolver::transferReduction() {
    for (std::int32_t i = 0; i < rows_; ++i) {
        const std::int32_t own = columnOf_[i];
        if (own < 0) continue;
        const double* c = row(i);
        double second = kInfinite;
        for (std::int32_t j = 0; j < columns_; ++j)
            if (j != own) second = std::min(second, c[j] - columnDual_[j]);
        if (second < kInfinite) columnDual_[own] -= second - (c[own] - columnDual_[own]);
    }
}

JonkerVolgenantSolver::TwoLowest JonkerVolgenantSolver::twoLowest(std::int32_t i) const {
    TwoLowest low{kInfinite, kInfinite, -1, -1};
    const double* c = row(i);
    const double* price = columnDual_.data();
    for (std::int32_t j = 0; j < columns_; ++j) {
        const double reduced = c[j] - price[j];
        if (!(reduced < low.second)) continue;
        if (reduced < low.first) {
            low.second = low.first;
            low.secondColumn = low.firstColumn;
            low.first = reduced;
            low.firstColumn = j;
        } else {
            low.second = reduced;
            low.secondColumn = j;
        }
    }
    return low;
}

// Augmenting row reduction: each free row bids for its best column and drives the former owner out.
// Rounding can make bids of nothing go round for ever, so the number of bids is bounded.
void JonkerVolgenantSolver::reduceRows() {
    freeNext_.clear();
    std::int32_t budget = 4 * rows_;
    for (const std::int32_t i : free_) reduceRow(i, budget);
    free_.swap(freeNext_);
}

void JonkerVolgenantSolver::reduceRow(std::int32_t i, std::int32_t& budget) {
    for (;;) {
        const TwoLowest low = twoLowest(i);
        if (low.firstColumn < 0) break;
        std::int32_t j = low.firstColumn;
        const bool strict = low.first < low.second;
        if (!strict && rowOf_[j] >= 0) j = low.secondColumn;
        const std::int32_t owner = rowOf_[j];
        // Driving an owner out at a tie gains nothing, and would turn ties away from the lower index.
        if (!strict && owner >= 0) break;
        // A row with a single choice has no bound for its bid: the search takes care of it.
        if (strict && owner >= 0 && low.second == kInfinite) break;
        if (strict && low.second < kInfinite) columnDual_[j] -= low.second - low.first;
        pair(i, j);
        if (owner < 0) return;
        columnOf_[owner] = -1;
        i = owner;
        if (--budget < 0) break;
    }
    freeNext_.push_back(i);
}

// Shortens the distances of open columns over row `i`; returns the least of them. The loops are straight so
// that compilers can turn them into vector code: a scanned column has the price minus infinity, which no way
// can beat.
double JonkerVolgenantSolver::relax(std::int32_t i, double offset) {
    const double* c = row(i);
    const double* price = openPrice_.data();
    double* distances = openDistance_.data();
    std::int64_t* through = through_.data();
    for (std::int32_t j = 0; j < columns_; ++j) {
        const double reached = c[j] - price[j] - offset;
        const bool nearer = reached < distances[j];
        distances[j] = nearer ? reached : distances[j];
        through[j] = nearer ? i : through[j];
    }
    double low[4] = {kInfinite, kInfinite, kInfinite, kInfinite};
    std::int32_t j = 0;
    for (; j + 4 <= columns_; j += 4)
        for (std::int32_t k = 0; k < 4; ++k) low[k] = distances[j + k] < low[k] ? distances[j + k] : low[k];
    for (; j < columns_; ++j) low[0] = std::min(low[0], distances[j]);
    return std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
}

// The open column at that distance: an unmatched one first, then the lower index.
std::int32_t JonkerVolgenantSolver::pick(double reached) const {
    std::int32_t matched = -1;
    for (std::int32_t j = 0; j < columns_; ++j) {
        if (openDistance_[j] != reached) continue;
        if (rowOf_[j] < 0) return j;
        if (matched < 0) matched = j;
    }
    return matched;
}

bool JonkerVolgenantSolver::augment(std::int32_t from) {
    ++augmentations_;
    scanned_.clear();
    openPrice_ = columnDual_;
    openDistance_.assign(columns_, kInfinite);
    double reached = relax(from, 0.0);
    while (reached < kInfinite) {
        const std::int32_t j = pick(reached);
        if (rowOf_[j] < 0) {
            for (const Scanned& done : scanned_) columnDual_[done.column] += done.distance - reached;
            flip(j, from);
            return true;
        }
        scanned_.push_back({j, reached});
        openPrice_[j] = -kInfinite;
        openDistance_[j] = kInfinite;
        const std::int32_t i = rowOf_[j];
        reached = relax(i, row(i)[j] - columnDual_[j] - reached);
    }
    return false;
}

void JonkerVolgenantSolver::flip(std::int32_t end, std::int32_t from) {
    for (std::int32_t j = end;;) {
        const auto i = static_cast<std::int32_t>(through_[j]);
        const std::int32_t next = columnOf_[i];
        pair(i, j);
        if (i == from) return;
        j = next;
    }
}

}  // namespace muster
