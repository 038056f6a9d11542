#include "engine/assignment/transport/dense/jonker_volgenant.h"

#include <algorithm>

#include "base/infinite_cost.h"

namespace muster {

bool JonkerVolgenantSolver::solve(std::int32_t rows, std::int32_t columns, const double* cost) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    augmentations_ = 0;
    columnOf_.assign(rows, -1);
    rowOf_.assign(columns, -1);
    rowDual_.assign(rows, 0.0);
    columnDual_.assign(columns, 0.0);
    predecessor_.assign(columns, -1);
    // A column that stays free must keep the dual 0, so columns are reduced only where none stays free.
    if (rows == columns) {
        columnReduction();
        reductionTransfer();
    }
    freeRows_.clear();
    for (std::int32_t i = 0; i < rows_; ++i)
        if (columnOf_[i] < 0) freeRows_.push_back(i);
    augmentingRowReduction();
    augmentingRowReduction();
    bool complete = true;
    std::sort(freeRows_.begin(), freeRows_.end());
    for (const std::int32_t i : freeRows_) complete = augmentFrom(i) && complete;
    for (std::int32_t i = 0; i < rows_; ++i)
        if (columnOf_[i] >= 0) rowDual_[i] = row(i)[columnOf_[i]] - columnDual_[columnOf_[i]];
    return complete;
}

// Sets the dual of each column to its least cost, and assigns each row the first free column whose cost that
// is.
void JonkerVolgenantSolver::columnReduction() {
    columnDual_.assign(columns_, kInfiniteCost);
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = row(i);
        for (std::int32_t j = 0; j < columns_; ++j) columnDual_[j] = std::min(columnDual_[j], c[j]);
    }
    for (double& dual : columnDual_)
        if (dual == kInfiniteCost) dual = 0.0;
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = row(i);
        for (std::int32_t j = 0; j < columns_; ++j) {
            if (c[j] != columnDual_[j] || rowOf_[j] >= 0) continue;
            assign(i, j);
            break;
        }
    }
}

// Lowers the dual of an assigned column until another column is as good for its row.
void JonkerVolgenantSolver::reductionTransfer() {
    for (std::int32_t i = 0; i < rows_; ++i) {
        const std::int32_t matched = columnOf_[i];
        if (matched < 0) continue;
        const double* c = row(i);
        double second = kInfiniteCost;
        for (std::int32_t j = 0; j < columns_; ++j)
            if (j != matched) second = std::min(second, c[j] - columnDual_[j]);
        if (second < kInfiniteCost) columnDual_[matched] -= second - (c[matched] - columnDual_[matched]);
    }
}

JonkerVolgenantSolver::TwoLowest JonkerVolgenantSolver::twoLowest(std::int32_t i) const {
    TwoLowest low{kInfiniteCost, kInfiniteCost, -1, -1};
    const double* c = row(i);
    const double* dual = columnDual_.data();
    for (std::int32_t j = 0; j < columns_; ++j) {
        const double reduced = c[j] - dual[j];
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

// Each free row takes its best column from the row that has it, which becomes free. Rounding can make that go
// on for ever without any gain, so the number of moves is bounded.
void JonkerVolgenantSolver::augmentingRowReduction() {
    nextFreeRows_.clear();
    std::int32_t budget = 4 * rows_;
    for (const std::int32_t i : freeRows_) reduceRow(i, budget);
    freeRows_.swap(nextFreeRows_);
}

void JonkerVolgenantSolver::reduceRow(std::int32_t i, std::int32_t& budget) {
    for (;;) {
        const TwoLowest low = twoLowest(i);
        if (low.firstColumn < 0) break;
        std::int32_t j = low.firstColumn;
        const bool strict = low.first < low.second;
        if (!strict && rowOf_[j] >= 0) j = low.secondColumn;
        const std::int32_t previous = rowOf_[j];
        // Taking a column at a tie gains nothing, and ties would no longer fall to the lower index.
        if (!strict && previous >= 0) break;
        // A row with a single choice has no bound for the dual; it is left to the search.
        if (strict && previous >= 0 && low.second == kInfiniteCost) break;
        if (strict && low.second < kInfiniteCost) columnDual_[j] -= low.second - low.first;
        assign(i, j);
        if (previous < 0) return;
        columnOf_[previous] = -1;
        i = previous;
        if (--budget < 0) break;
    }
    nextFreeRows_.push_back(i);
}

// Shortens the distances of open columns over row `i`; returns the least of them. The loops have no
// branches, so that compilers vectorise them: the dual of a settled column is minus infinity, so that its
// distance never becomes shorter.
double JonkerVolgenantSolver::relax(std::int32_t i, double offset) {
    const double* c = row(i);
    const double* dual = openDual_.data();
    double* distances = openDistance_.data();
    std::int64_t* predecessor = predecessor_.data();
    for (std::int32_t j = 0; j < columns_; ++j) {
        const double reached = c[j] - dual[j] - offset;
        const bool nearer = reached < distances[j];
        distances[j] = nearer ? reached : distances[j];
        predecessor[j] = nearer ? i : predecessor[j];
    }
    double low[4] = {kInfiniteCost, kInfiniteCost, kInfiniteCost, kInfiniteCost};
    std::int32_t j = 0;
    for (; j + 4 <= columns_; j += 4)
        for (std::int32_t k = 0; k < 4; ++k) low[k] = distances[j + k] < low[k] ? distances[j + k] : low[k];
    for (; j < columns_; ++j) low[0] = std::min(low[0], distances[j]);
    return std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
}

// The open column at `distance`: a free one first, then the lower index.
std::int32_t JonkerVolgenantSolver::columnAt(double distance) const {
    std::int32_t matched = -1;
    for (std::int32_t j = 0; j < columns_; ++j) {
        if (openDistance_[j] != distance) continue;
        if (rowOf_[j] < 0) return j;
        if (matched < 0) matched = j;
    }
    return matched;
}

// Finds the shortest path from a free row to a free column and exchanges assignments along it; false where
// there is none.
bool JonkerVolgenantSolver::augmentFrom(std::int32_t start) {
    ++augmentations_;
    settled_.clear();
    openDual_ = columnDual_;
    openDistance_.assign(columns_, kInfiniteCost);
    double reached = relax(start, 0.0);
    while (reached < kInfiniteCost) {
        const std::int32_t j = columnAt(reached);
        if (rowOf_[j] < 0) {
            for (const Settled& settled : settled_) columnDual_[settled.column] += settled.distance - reached;
            alternate(j, start);
            return true;
        }
        settled_.push_back({j, reached});
        openDual_[j] = -kInfiniteCost;
        openDistance_[j] = kInfiniteCost;
        const std::int32_t i = rowOf_[j];
        reached = relax(i, row(i)[j] - columnDual_[j] - reached);
    }
    return false;
}

void JonkerVolgenantSolver::alternate(std::int32_t column, std::int32_t start) {
    for (std::int32_t j = column;;) {
        const auto i = static_cast<std::int32_t>(predecessor_[j]);
        const std::int32_t next = columnOf_[i];
        assign(i, j);
        if (i == start) return;
        j = next;
    }
}

}  // namespace muster
