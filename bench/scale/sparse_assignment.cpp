#include "scale/sparse_assignment.h"

#include <algorithm>

namespace muster::scale {
namespace {

constexpr std::int64_t kReductions = 8;  // Reductions per row, after which rows are left to augmenting paths.

struct TwoBest {
    double first = kInfinite;
    double second = kInfinite;
    std::int32_t column = -1;
};

TwoBest twoBest(const std::vector<Arc>& arcs, const std::vector<double>& dual) {
    TwoBest best;
    for (const Arc& arc : arcs) {
        const double reduced = arc.cost - dual[arc.column];
        if (reduced < best.first) {
            best.second = best.first;
            best.first = reduced;
            best.column = arc.column;
        } else {
            best.second = std::min(best.second, reduced);
        }
    }
    return best;
}

}  // namespace

// Augmenting row reduction: matches a row to its column of least reduced cost and lowers the dual of that
// column until the second best is as good. The row that had the column is reduced next.
void SparseAssignment::reduce(std::span<const std::vector<Arc>> rows) {
    std::vector<std::int32_t> waiting;
    for (std::size_t r = rows.size(); r-- > 0;) waiting.push_back(static_cast<std::int32_t>(r));
    std::int64_t tries = kReductions * static_cast<std::int64_t>(rows.size());
    while (!waiting.empty()) {
        const std::int32_t row = waiting.back();
        waiting.pop_back();
        const TwoBest best = twoBest(rows[row], dual_);
        const std::int32_t owner = best.column >= 0 ? rowOf_[best.column] : 0;
        const bool lowers = best.second < kInfinite && best.second > best.first;
        if (best.column < 0 || (owner >= 0 && (!lowers || tries-- <= 0))) {
            free_.push_back(row);
            continue;
        }
        if (lowers) dual_[best.column] -= best.second - best.first;
        rowOf_[best.column] = row;
        columnOf_[row] = best.column;
        if (owner < 0) continue;
        columnOf_[owner] = -1;
        waiting.push_back(owner);
    }
}

// `from` is the length of the path to the row less the row's own dual.
void SparseAssignment::relax(std::span<const std::vector<Arc>> rows, std::int32_t row, double from) {
    for (const Arc& arc : rows[row]) {
        if (settled_[arc.column]) continue;
        const double length = from + arc.cost - dual_[arc.column];
        if (!(length < distance_[arc.column])) continue;
        if (distance_[arc.column] == kInfinite) touched_.push_back(arc.column);
        distance_[arc.column] = length;
        parentRow_[arc.column] = row;
        heap_.push_back({length, arc.column});
        std::push_heap(heap_.begin(), heap_.end());
    }
}

bool SparseAssignment::augment(std::span<const std::vector<Arc>> rows, std::int32_t row) {
    touched_.clear();
    order_.clear();
    heap_.clear();
    relax(rows, row, 0.0);
    std::int32_t end = -1;
    while (!heap_.empty() && end < 0) {
        const Entry entry = heap_.front();
        std::pop_heap(heap_.begin(), heap_.end());
        heap_.pop_back();
        if (settled_[entry.column] || entry.distance > distance_[entry.column]) continue;
        settled_[entry.column] = 1;
        order_.push_back(entry.column);
        const std::int32_t owner = rowOf_[entry.column];
        if (owner < 0) {
            end = entry.column;
            break;
        }
        // The arc of a matched row has reduced cost zero, which gives the dual of the row.
        double own = 0.0;
        for (const Arc& arc : rows[owner])
            if (arc.column == entry.column) own = arc.cost - dual_[arc.column];
        relax(rows, owner, entry.distance - own);
    }
    if (end >= 0) {
        const double whole = distance_[end];
        for (const std::int32_t column : order_) dual_[column] += distance_[column] - whole;
        for (std::int32_t column = end; column >= 0;) {
            const std::int32_t taker = parentRow_[column];
            rowOf_[column] = taker;
            std::swap(columnOf_[taker], column);
            if (taker == row) break;
        }
    }
    for (const std::int32_t column : touched_) {
        distance_[column] = kInfinite;
        settled_[column] = 0;
    }
    return end >= 0;
}

bool SparseAssignment::solve(std::span<const std::vector<Arc>> rows, std::int32_t columns,
                             std::span<const double> start) {
    columnOf_.assign(rows.size(), -1);
    rowOf_.assign(static_cast<std::size_t>(columns), -1);
    dual_.assign(static_cast<std::size_t>(columns), 0.0);
    if (!start.empty()) dual_.assign(start.begin(), start.end());
    distance_.assign(static_cast<std::size_t>(columns), kInfinite);
    parentRow_.assign(static_cast<std::size_t>(columns), -1);
    settled_.assign(static_cast<std::size_t>(columns), 0);
    free_.clear();
    reduce(rows);
    bool all = true;
    for (const std::int32_t row : free_) all = augment(rows, row) && all;
    return all;
}

}  // namespace muster::scale
