#include "assignment/dense/successive_shortest_paths.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

void SuccessiveShortestPaths::reset(std::span<const double> supply, std::span<const double> demand) {
    augmentations_ = 0;
    flow_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0.0);
    excess_.assign(supply.begin(), supply.end());
    spare_.assign(demand.begin(), demand.end());
    columnDual_.assign(columns_, 0.0);
    rowDual_.assign(rows_, 0.0);
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double* c = cost_ + static_cast<std::size_t>(i) * static_cast<std::size_t>(columns_);
        const double lowest = *std::min_element(c, c + columns_);
        if (lowest < kInfinite) rowDual_[i] = lowest;
    }
    rowDistance_.assign(rows_, kInfinite);
    rowThrough_.assign(rows_, -1);
    columnThrough_.assign(columns_, -1);
}

bool SuccessiveShortestPaths::solve(std::int32_t rows, std::int32_t columns, const double* cost,
                                    std::span<const double> supply, std::span<const double> demand,
                                    double dust) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    dust_ = dust;
    reset(supply, demand);
    bool complete = true;
    for (std::int32_t i = 0; i < rows_; ++i) {
        while (excess_[i] > dust_) {
            if (augment(i)) continue;
            complete = false;
            break;
        }
    }
    return complete;
}

// Shortens the distances of open columns over row `row`.
void SuccessiveShortestPaths::relax(std::int32_t row) {
    const double* c = cost_ + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    const double base = rowDistance_[row] - rowDual_[row];
    for (const std::int32_t j : open_) {
        const double reached = base + c[j] - columnDual_[j];
        if (reached < columnDistance_[j]) {
            columnDistance_[j] = reached;
            columnThrough_[j] = row;
        }
    }
}

// Position in open_ of the nearest column, -1 where none can be reached. Ties fall to a column with demand
// left, then to the lower index.
std::int32_t SuccessiveShortestPaths::nearest() const {
    std::int32_t best = -1;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(open_.size()); ++k) {
        const std::int32_t j = open_[k];
        if (columnDistance_[j] == kInfinite) continue;
        if (best < 0 || columnDistance_[j] < columnDistance_[open_[best]]) {
            best = k;
        } else if (columnDistance_[j] == columnDistance_[open_[best]]) {
            const bool here = spare_[j] > dust_;
            const bool there = spare_[open_[best]] > dust_;
            if (here != there ? here : j < open_[best]) best = k;
        }
    }
    return best;
}

// Goes from a full column back to the rows that fill it.
void SuccessiveShortestPaths::enter(std::int32_t column) {
    for (std::int32_t i = 0; i < rows_; ++i) {
        if (flow_[at(i, column)] <= dust_ || rowDistance_[i] < kInfinite) continue;
        rowDistance_[i] = columnDistance_[column];
        rowThrough_[i] = column;
        entered_.push_back(i);
        relax(i);
    }
}

bool SuccessiveShortestPaths::augment(std::int32_t from) {
    ++augmentations_;
    columnDistance_.assign(columns_, kInfinite);
    open_.resize(columns_);
    for (std::int32_t j = 0; j < columns_; ++j) open_[j] = j;
    scanned_.clear();
    for (const std::int32_t i : entered_) rowDistance_[i] = kInfinite;
    entered_.assign(1, from);
    rowDistance_[from] = 0.0;
    rowThrough_[from] = -1;
    relax(from);
    for (std::int32_t best = nearest(); best >= 0; best = nearest()) {
        const std::int32_t j = open_[best];
        if (spare_[j] > dust_) {
            reprice(columnDistance_[j]);
            send(from, j);
            return true;
        }
        open_[best] = open_.back();
        open_.pop_back();
        scanned_.push_back(j);
        enter(j);
    }
    return false;
}

// Changes prices so that the path just found becomes tight and no arc is underpriced.
void SuccessiveShortestPaths::reprice(double reached) {
    for (const std::int32_t i : entered_) rowDual_[i] += reached - rowDistance_[i];
    for (const std::int32_t j : scanned_) columnDual_[j] -= reached - columnDistance_[j];
}

void SuccessiveShortestPaths::send(std::int32_t from, std::int32_t end) {
    double amount = std::min(excess_[from], spare_[end]);
    for (std::int32_t i = columnThrough_[end]; i != from; i = columnThrough_[rowThrough_[i]])
        amount = std::min(amount, flow_[at(i, rowThrough_[i])]);
    for (std::int32_t j = end;;) {
        const std::int32_t i = columnThrough_[j];
        flow_[at(i, j)] += amount;
        if (i == from) break;
        j = rowThrough_[i];
        flow_[at(i, j)] -= amount;
    }
    excess_[from] -= amount;
    spare_[end] -= amount;
}

}  // namespace muster
