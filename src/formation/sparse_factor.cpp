#include "formation/sparse_factor.h"

#include <cmath>

namespace muster {

bool SparseFactor::factorise(int size, const std::vector<SparseEntry>& entries) {
    order_.clear();
    start_.assign(1, 0);
    row_.clear();
    value_.clear();
    diagonal_.clear();
    if (size == 0) return true;
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(matrix);
    if (ldlt.info() != Eigen::Success) return false;
    const auto& lower = ldlt.matrixL().nestedExpression();
    const auto& place = ldlt.permutationP().indices();
    double largest = 0.0;
    for (int j = 0; j < size; ++j) largest = std::fmax(largest, ldlt.vectorD()[j]);
    for (int j = 0; j < size; ++j) {
        const double d = ldlt.vectorD()[j];
        // Written so that a NaN fails too.
        if (!(d > 1e-14 * largest)) return false;
        diagonal_.push_back(d);
        order_.push_back(place.size() == size ? place[j] : j);
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, j); it; ++it) {
            if (it.row() <= j) continue;
            row_.push_back(static_cast<int>(it.row()));
            value_.push_back(it.value());
        }
        start_.push_back(static_cast<int>(row_.size()));
    }
    work_.assign(static_cast<std::size_t>(size), 0.0);
    return true;
}

void SparseFactor::solve(std::vector<double>& values) {
    const std::size_t n = diagonal_.size();
    for (std::size_t i = 0; i < n; ++i) work_[static_cast<std::size_t>(order_[i])] = values[i];
    for (std::size_t j = 0; j < n; ++j) {
        const double x = work_[j];
        for (int k = start_[j]; k < start_[j + 1]; ++k)
            work_[static_cast<std::size_t>(row_[static_cast<std::size_t>(k)])] -= value_[static_cast<std::size_t>(k)] * x;
    }
    for (std::size_t j = 0; j < n; ++j) work_[j] /= diagonal_[j];
    for (std::size_t j = n; j-- > 0;) {
        double x = work_[j];
        for (int k = start_[j]; k < start_[j + 1]; ++k)
            x -= value_[static_cast<std::size_t>(k)] * work_[static_cast<std::size_t>(row_[static_cast<std::size_t>(k)])];
        work_[j] = x;
    }
    for (std::size_t i = 0; i < n; ++i) values[i] = work_[static_cast<std::size_t>(order_[i])];
}

}  // namespace muster
