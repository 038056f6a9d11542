#include "assignment/dense/dulmage_mendelsohn.h"

#include <algorithm>
#include <limits>

namespace muster {

bool DulmageMendelsohn::possible(std::int32_t row, std::int32_t column) const {
    const std::size_t k = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(column);
    return cost_[k] < std::numeric_limits<double>::infinity();
}

void DulmageMendelsohn::find(std::int32_t rows, std::int32_t columns, const double* cost,
                             std::span<const double> supply, std::span<const double> demand, double dust) {
    cost_ = cost;
    rows_ = rows;
    columns_ = columns;
    dust_ = dust;
    flow_.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), 0.0);
    excess_.assign(supply.begin(), supply.end());
    spare_.assign(demand.begin(), demand.end());
    rowThrough_.assign(rows, -1);
    columnThrough_.assign(columns, -1);
    fillGreedily();
    // Within one round no column is looked at twice, so a round costs rows x columns at most; columns that
    // led nowhere for one row lead nowhere for the next, unless a path was found meanwhile: hence the rounds.
    for (bool found = true; found;) {
        found = false;
        openAll();
        for (std::int32_t i = 0; i < rows_; ++i) {
            if (excess_[i] <= dust_) continue;
            const std::int32_t end = search(i);
            if (end < 0) continue;
            send(i, end);
            found = true;
        }
    }
    rowPart_.assign(rows, DulmageMendelsohnPart::Even);
    columnPart_.assign(columns, DulmageMendelsohnPart::Even);
    markRowsLeft();
    markColumnsLeft();
}

void DulmageMendelsohn::fillGreedily() {
    for (std::int32_t i = 0; i < rows_; ++i) {
        for (std::int32_t j = 0; j < columns_ && excess_[i] > dust_; ++j) {
            if (spare_[j] <= dust_ || !possible(i, j)) continue;
            const double amount = std::min(excess_[i], spare_[j]);
            flow_[at(i, j)] = amount;
            excess_[i] -= amount;
            spare_[j] -= amount;
        }
    }
}

void DulmageMendelsohn::openAll() {
    entered_.assign(rows_, 0);
    open_.resize(columns_);
    for (std::int32_t j = 0; j < columns_; ++j) open_[j] = j;
}

// Breadth first from a row over open columns; returns a column with demand left, or -1.
std::int32_t DulmageMendelsohn::search(std::int32_t from) {
    queue_.assign(1, from);
    entered_[from] = 1;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const std::int32_t i = queue_[head];
        std::size_t kept = 0;
        std::int32_t end = -1;
        for (const std::int32_t j : open_) {
            if (end >= 0 || !possible(i, j)) {
                open_[kept++] = j;
                continue;
            }
            columnThrough_[j] = i;
            if (spare_[j] > dust_) end = j;
            for (std::int32_t k = 0; k < rows_ && end < 0; ++k) {
                if (flow_[at(k, j)] <= dust_ || entered_[k]) continue;
                entered_[k] = 1;
                rowThrough_[k] = j;
                queue_.push_back(k);
            }
        }
        open_.resize(kept);
        if (end >= 0) return end;
    }
    return -1;
}

void DulmageMendelsohn::send(std::int32_t from, std::int32_t end) {
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

// What a row with something left can reach: just what the last, fruitless round entered.
void DulmageMendelsohn::markRowsLeft() {
    for (std::int32_t i = 0; i < rows_; ++i)
        if (entered_[i]) rowPart_[i] = DulmageMendelsohnPart::RowsLeft;
    std::fill(columnPart_.begin(), columnPart_.end(), DulmageMendelsohnPart::RowsLeft);
    for (const std::int32_t j : open_) columnPart_[j] = DulmageMendelsohnPart::Even;
}

// What can reach a column with demand left.
void DulmageMendelsohn::markColumnsLeft() {
    queue_.clear();
    const auto mark = [&](std::int32_t j) {
        columnPart_[j] = DulmageMendelsohnPart::ColumnsLeft;
        queue_.push_back(j);
    };
    for (std::int32_t j = 0; j < columns_; ++j)
        if (spare_[j] > dust_) mark(j);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        for (std::int32_t i = 0; i < rows_; ++i) {
            if (rowPart_[i] == DulmageMendelsohnPart::ColumnsLeft || !possible(i, queue_[head])) continue;
            rowPart_[i] = DulmageMendelsohnPart::ColumnsLeft;
            for (std::int32_t j = 0; j < columns_; ++j)
                if (columnPart_[j] != DulmageMendelsohnPart::ColumnsLeft && flow_[at(i, j)] > dust_) mark(j);
        }
    }
}

}  // namespace muster
