#include "engine/assignment/transport/dense/dense_flow.h"

#include <algorithm>

namespace muster {

void DenseFlow::reset(std::span<const double> supply, std::span<const double> demand) {
    rows = static_cast<std::int32_t>(supply.size());
    amount.assign(supply.size() * demand.size(), 0.0);
    remainingSupply.assign(supply.begin(), supply.end());
    remainingDemand.assign(demand.begin(), demand.end());
    rowPredecessor.assign(supply.size(), -1);
    columnPredecessor.assign(demand.size(), -1);
}

void DenseFlow::augment(std::int32_t row, std::int32_t column) {
    double sent = std::min(remainingSupply[row], remainingDemand[column]);
    for (std::int32_t i = columnPredecessor[column]; i != row; i = columnPredecessor[rowPredecessor[i]])
        sent = std::min(sent, at(i, rowPredecessor[i]));
    for (std::int32_t j = column;;) {
        const std::int32_t i = columnPredecessor[j];
        at(i, j) += sent;
        if (i == row) break;
        j = rowPredecessor[i];
        at(i, j) -= sent;
    }
    remainingSupply[row] -= sent;
    remainingDemand[column] -= sent;
}

}  // namespace muster
