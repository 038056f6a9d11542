#include "engine/assignment/transport/dense/dulmage_mendelsohn.h"

#include <algorithm>

#include "base/infinite_cost.h"

namespace muster {

bool DulmageMendelsohn::isPossible(std::int32_t row, std::int32_t column) const {
    const std::size_t k = static_cast<std::size_t>(row) * columns_ + column;
    return cost_[k] < kInfiniteCost;
}

void DulmageMendelsohn::decompose(std::int32_t rows, std::int32_t columns, const double* cost,
                                  std::span<const double> supply, std::span<const double> demand,
                                  double negligible) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    negligible_ = negligible;
    flow_.reset(supply, demand);
    fillGreedily();
    // No column is reached twice in a round, so a round visits every pair at most once. A column from which
    // one row found no path gives none to the next row either, unless a path was found meanwhile: hence the
    // rounds.
    for (bool found = true; found;) {
        found = false;
        openAllColumns();
        for (std::int32_t i = 0; i < rows_; ++i) {
            if (flow_.remainingSupply[i] <= negligible_) continue;
            const std::int32_t j = findAugmentingPath(i);
            if (j < 0) continue;
            flow_.augment(i, j);
            found = true;
        }
    }
    rowPart_.assign(rows, DulmageMendelsohnPart::Square);
    columnPart_.assign(columns, DulmageMendelsohnPart::Square);
    markVertical();
    markHorizontal();
}

void DulmageMendelsohn::fillGreedily() {
    for (std::int32_t i = 0; i < rows_; ++i) {
        for (std::int32_t j = 0; j < columns_ && flow_.remainingSupply[i] > negligible_; ++j) {
            if (flow_.remainingDemand[j] <= negligible_ || !isPossible(i, j)) continue;
            const double amount = std::min(flow_.remainingSupply[i], flow_.remainingDemand[j]);
            flow_.at(i, j) = amount;
            flow_.remainingSupply[i] -= amount;
            flow_.remainingDemand[j] -= amount;
        }
    }
}

void DulmageMendelsohn::openAllColumns() {
    isReached_.assign(rows_, 0);
    openColumns_.resize(columns_);
    for (std::int32_t j = 0; j < columns_; ++j) openColumns_[j] = j;
}

// Breadth-first search from a row over open columns; returns a column with demand left, or -1.
std::int32_t DulmageMendelsohn::findAugmentingPath(std::int32_t row) {
    queue_.assign(1, row);
    isReached_[row] = 1;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const std::int32_t i = queue_[head];
        std::size_t open = 0;
        std::int32_t end = -1;
        for (const std::int32_t j : openColumns_) {
            if (end >= 0 || !isPossible(i, j)) {
                openColumns_[open++] = j;
                continue;
            }
            flow_.columnPredecessor[j] = i;
            if (flow_.remainingDemand[j] > negligible_) end = j;
            for (std::int32_t k = 0; k < rows_ && end < 0; ++k) {
                if (flow_.at(k, j) <= negligible_ || isReached_[k]) continue;
                isReached_[k] = 1;
                flow_.rowPredecessor[k] = j;
                queue_.push_back(k);
            }
        }
        openColumns_.resize(open);
        if (end >= 0) return end;
    }
    return -1;
}

// Marks rows and columns that are reached from rows with supply left: those of the last round, which found no
// path.
void DulmageMendelsohn::markVertical() {
    for (std::int32_t i = 0; i < rows_; ++i)
        if (isReached_[i]) rowPart_[i] = DulmageMendelsohnPart::Vertical;
    std::fill(columnPart_.begin(), columnPart_.end(), DulmageMendelsohnPart::Vertical);
    for (const std::int32_t j : openColumns_) columnPart_[j] = DulmageMendelsohnPart::Square;
}

// Marks rows and columns from which a column with demand left is reached.
void DulmageMendelsohn::markHorizontal() {
    queue_.clear();
    const auto mark = [&](std::int32_t j) {
        columnPart_[j] = DulmageMendelsohnPart::Horizontal;
        queue_.push_back(j);
    };
    for (std::int32_t j = 0; j < columns_; ++j)
        if (flow_.remainingDemand[j] > negligible_) mark(j);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        for (std::int32_t i = 0; i < rows_; ++i) {
            if (rowPart_[i] == DulmageMendelsohnPart::Horizontal || !isPossible(i, queue_[head])) continue;
            rowPart_[i] = DulmageMendelsohnPart::Horizontal;
            for (std::int32_t j = 0; j < columns_; ++j)
                if (columnPart_[j] != DulmageMendelsohnPart::Horizontal && flow_.at(i, j) > negligible_)
                    mark(j);
        }
    }
}

}  // namespace muster
