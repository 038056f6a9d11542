#include "transport/unit_matching.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

void UnitMatching::pair(std::int32_t i, std::int32_t j) {
    columnOf_[i] = j;
    rowOf_[j] = i;
}

bool UnitMatching::solve(std::int32_t rows, std::int32_t columns, const double* cost) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    augmentations_ = 0;
    columnOf_.assign(rows, -1);
    rowOf_.assign(columns, -1);
    rowPrice_.assign(rows, 0.0);
    columnPrice_.assign(columns, 0.0);
    distance_.resize(columns);
    through_.resize(columns);
    open_.resize(columns);
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
        if (columnOf_[i] >= 0) rowPrice_[i] = row(i)[columnOf_[i]] - columnPrice_[columnOf_[i]];
    return complete;
}

// Prices each column at its least cost, and lets each row take the first free column that is tight.
void UnitMatching::reduceColumns() {
    columnPrice_.assign(columns_, kInfinite);
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = row(i);
        for (std::int32_t j = 0; j < columns_; ++j) columnPrice_[j] = std::min(columnPrice_[j], c[j]);
    }
    for (double& price : columnPrice_)
        if (price == kInfinite) price = 0.0;
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = row(i);
        for (std::int32_t j = 0; j < columns_; ++j) {
            if (c[j] != columnPrice_[j] || rowOf_[j] >= 0) continue;
            pair(i, j);
            break;
        }
    }
}

// Lowers the price of a matched column to where its row becomes indifferent to its second choice.
void UnitMatching::transferReduction() {
    for (std::int32_t i = 0; i < rows_; ++i) {
        const std::int32_t own = columnOf_[i];
        if (own < 0) continue;
        const double* c = row(i);
        double second = kInfinite;
        for (std::int32_t j = 0; j < columns_; ++j)
            if (j != own) second = std::min(second, c[j] - columnPrice_[j]);
        if (second < kInfinite) columnPrice_[own] -= second - (c[own] - columnPrice_[own]);
    }
}

UnitMatching::TwoLowest UnitMatching::twoLowest(std::int32_t i) const {
    TwoLowest low{kInfinite, kInfinite, -1, -1};
    const double* c = row(i);
    const double* price = columnPrice_.data();
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
void UnitMatching::reduceRows() {
    freeNext_.clear();
    std::int32_t budget = 4 * rows_;
    for (const std::int32_t i : free_) reduceRow(i, budget);
    free_.swap(freeNext_);
}

void UnitMatching::reduceRow(std::int32_t i, std::int32_t& budget) {
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
        if (strict && low.second < kInfinite) columnPrice_[j] -= low.second - low.first;
        pair(i, j);
        if (owner < 0) return;
        columnOf_[owner] = -1;
        i = owner;
        if (--budget < 0) break;
    }
    freeNext_.push_back(i);
}

// Order of columns in the search: nearer, then unmatched, then the lower index.
bool UnitMatching::before(std::int32_t a, std::int32_t b) const {
    if (distance_[a] != distance_[b]) return distance_[a] < distance_[b];
    const bool freeA = rowOf_[a] < 0;
    const bool freeB = rowOf_[b] < 0;
    return freeA != freeB ? freeA : a < b;
}

// Shortens the distances of open columns over row `i`; returns the position in open_ of the nearest, -1 for none.
std::int32_t UnitMatching::relax(std::int32_t i, double offset) {
    const double* c = row(i);
    const double* price = columnPrice_.data();
    double* distances = distance_.data();
    double lowest = kInfinite;
    std::int32_t best = -1;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(open_.size()); ++k) {
        const std::int32_t j = open_[k];
        const double reached = c[j] - price[j] - offset;
        double now = distances[j];
        if (reached < now) {
            distances[j] = now = reached;
            through_[j] = i;
        }
        if (now > lowest || now == kInfinite) continue;
        if (now < lowest || before(j, open_[best])) {
            lowest = now;
            best = k;
        }
    }
    return best;
}

bool UnitMatching::augment(std::int32_t from) {
    ++augmentations_;
    scanned_.clear();
    open_.resize(columns_);
    for (std::int32_t j = 0; j < columns_; ++j) {
        open_[j] = j;
        distance_[j] = kInfinite;
    }
    std::int32_t best = relax(from, 0.0);
    while (best >= 0) {
        const std::int32_t j = open_[best];
        const double reached = distance_[j];
        if (rowOf_[j] < 0) {
            for (const std::int32_t k : scanned_) columnPrice_[k] += distance_[k] - reached;
            flip(j, from);
            return true;
        }
        open_[best] = open_.back();
        open_.pop_back();
        scanned_.push_back(j);
        const std::int32_t i = rowOf_[j];
        best = relax(i, row(i)[j] - columnPrice_[j] - reached);
    }
    return false;
}

void UnitMatching::flip(std::int32_t end, std::int32_t from) {
    for (std::int32_t j = end;;) {
        const std::int32_t i = through_[j];
        const std::int32_t next = columnOf_[i];
        pair(i, j);
        if (i == from) return;
        j = next;
    }
}

}  // namespace muster
