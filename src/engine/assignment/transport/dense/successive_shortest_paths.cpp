#include "engine/assignment/transport/dense/successive_shortest_paths.h"

#include <algorithm>
#include <iterator>

#include "base/infinite_cost.h"

namespace muster {

void SuccessiveShortestPaths::reset(std::span<const double> supply, std::span<const double> demand) {
    augmentations_ = 0;
    flow_.reset(supply, demand);
    columnDual_.assign(columns_, 0.0);
    rowDual_.assign(rows_, 0.0);
    for (std::int32_t i = 0; i < rows_; ++i) {
        const double lowest = *std::min_element(row(i), row(i) + columns_);
        if (lowest < kInfiniteCost) rowDual_[i] = lowest;
    }
    rowDistance_.assign(rows_, kInfiniteCost);
}

bool SuccessiveShortestPaths::solve(std::int32_t rows, std::int32_t columns, const double* cost,
                                    std::span<const double> supply, std::span<const double> demand,
                                    double negligible) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    negligible_ = negligible;
    reset(supply, demand);
    bool complete = true;
    for (std::int32_t i = 0; i < rows_; ++i) {
        while (flow_.remainingSupply[i] > negligible_) {
            if (sendFrom(i)) continue;
            complete = false;
            break;
        }
    }
    return complete;
}

// Shortens the distances of open columns over a row.
void SuccessiveShortestPaths::relax(std::int32_t i) {
    const double* c = row(i);
    const double base = rowDistance_[i] - rowDual_[i];
    for (const std::int32_t j : openColumns_) {
        const double distance = base + c[j] - columnDual_[j];
        if (distance < columnDistance_[j]) {
            columnDistance_[j] = distance;
            flow_.columnPredecessor[j] = i;
        }
    }
}

// Index in openColumns_ of the nearest column, -1 where none can be reached. Ties fall to a column with
// demand left, then to the lower index.
std::int32_t SuccessiveShortestPaths::nearestOpenColumn() const {
    std::int32_t best = -1;
    for (std::int32_t k = 0; k < std::ssize(openColumns_); ++k) {
        const std::int32_t j = openColumns_[k];
        if (columnDistance_[j] == kInfiniteCost) continue;
        if (best < 0 || columnDistance_[j] < columnDistance_[openColumns_[best]]) {
            best = k;
        } else if (columnDistance_[j] == columnDistance_[openColumns_[best]]) {
            const bool here = flow_.remainingDemand[j] > negligible_;
            const bool there = flow_.remainingDemand[openColumns_[best]] > negligible_;
            if (here != there ? here : j < openColumns_[best]) best = k;
        }
    }
    return best;
}

// Goes back from a full column to the rows that fill it.
void SuccessiveShortestPaths::reachRowsOf(std::int32_t column) {
    for (std::int32_t i = 0; i < rows_; ++i) {
        if (flow_.at(i, column) <= negligible_ || rowDistance_[i] < kInfiniteCost) continue;
        rowDistance_[i] = columnDistance_[column];
        flow_.rowPredecessor[i] = column;
        reachedRows_.push_back(i);
        relax(i);
    }
}

// Finds the shortest path from a row to a column with demand left and sends as much as it can carry; false
// where there is none.
bool SuccessiveShortestPaths::sendFrom(std::int32_t row) {
    ++augmentations_;
    columnDistance_.assign(columns_, kInfiniteCost);
    openColumns_.resize(columns_);
    for (std::int32_t j = 0; j < columns_; ++j) openColumns_[j] = j;
    settledColumns_.clear();
    for (const std::int32_t i : reachedRows_) rowDistance_[i] = kInfiniteCost;
    reachedRows_.assign(1, row);
    rowDistance_[row] = 0.0;
    flow_.rowPredecessor[row] = -1;
    relax(row);
    for (std::int32_t best = nearestOpenColumn(); best >= 0; best = nearestOpenColumn()) {
        const std::int32_t j = openColumns_[best];
        if (flow_.remainingDemand[j] > negligible_) {
            updateDuals(columnDistance_[j]);
            flow_.augment(row, j);
            return true;
        }
        openColumns_[best] = openColumns_.back();
        openColumns_.pop_back();
        settledColumns_.push_back(j);
        reachRowsOf(j);
    }
    return false;
}

// Makes the reduced costs along the path just found zero, and none negative.
void SuccessiveShortestPaths::updateDuals(double distance) {
    for (const std::int32_t i : reachedRows_) rowDual_[i] += distance - rowDistance_[i];
    for (const std::int32_t j : settledColumns_) columnDual_[j] -= distance - columnDistance_[j];
}

}  // namespace muster
