#include "engine/formation/mesh/sparse_ldlt.h"

#include <cmath>

namespace muster {
bool SparseLdlt::factorise(int size, const std::vector<SparseEntry>& entries) {
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
    const auto& position = ldlt.permutationP().indices();
    double largest = 0.0;
    for (int j = 0; j < size; ++j) largest = std::fmax(largest, ldlt.vectorD()[j]);
    for (int j = 0; j < size; ++j) {
        const double d = ldlt.vectorD()[j];
        // Written so that a NaN fails too.
        if (!(d > 1e-14 * largest)) return false;
        diagonal_.push_back(d);
        order_.push_back(position.size() == size ? position[j] : j);
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, j); it; ++it) {
            if (it.row() <= j) continue;
            row_.push_back(static_cast<int>(it.row()));
            value_.push_back(it.value());
        }
        start_.push_back(static_cast<int>(row_.size()));
    }
    findPairs();
    work_.assign(size, 0.0);
    workPoints_.assign(size, {});
    return true;
}

// Finds pairs of rows. Where unknowns are coordinates most rows come as x and y of a point, which are
// substituted in pairs.
void SparseLdlt::findPairs() {
    paired_.clear();
    for (std::size_t j = 0; j < diagonal_.size(); ++j) {
        int from = start_[j + 1];
        while (from - 2 >= start_[j] && row_[from - 1] == row_[from - 2] + 1) from -= 2;
        paired_.push_back(from);
    }
}

void SparseLdlt::solve(std::vector<double>& values) {
    const std::size_t n = diagonal_.size();
    for (std::size_t i = 0; i < n; ++i) work_[order_[i]] = values[i];
    for (std::size_t j = 0; j < n; ++j) {
        const double x = work_[j];
        int k = start_[j];
        for (; k < paired_[j]; ++k) work_[row_[k]] -= value_[k] * x;
        for (; k < start_[j + 1]; k += 2) {
            double* const w = &work_[row_[k]];
            const double first = w[0] - value_[k] * x;
            const double second = w[1] - value_[k + 1] * x;
            w[0] = first;
            w[1] = second;
        }
    }
    for (std::size_t j = 0; j < n; ++j) work_[j] /= diagonal_[j];
    for (std::size_t j = n; j-- > 0;) {
        double x = work_[j];
        int k = start_[j];
        for (; k < paired_[j]; ++k) x -= value_[k] * work_[row_[k]];
        for (; k < start_[j + 1]; k += 2) {
            const double* const w = &work_[row_[k]];
            x -= value_[k] * w[0];
            x -= value_[k + 1] * w[1];
        }
        work_[j] = x;
    }
    for (std::size_t i = 0; i < n; ++i) values[i] = work_[order_[i]];
}

void SparseLdlt::solve(std::vector<Vec2>& values) {
    const std::size_t n = diagonal_.size();
    for (std::size_t i = 0; i < n; ++i) workPoints_[order_[i]] = values[i];
    for (std::size_t j = 0; j < n; ++j) {
        const Vec2 x = workPoints_[j];
        for (int k = start_[j]; k < start_[j + 1]; ++k) workPoints_[row_[k]] -= value_[k] * x;
    }
    for (std::size_t j = 0; j < n; ++j) workPoints_[j] = workPoints_[j] / diagonal_[j];
    for (std::size_t j = n; j-- > 0;) {
        Vec2 x = workPoints_[j];
        for (int k = start_[j]; k < start_[j + 1]; ++k) x -= value_[k] * workPoints_[row_[k]];
        workPoints_[j] = x;
    }
    for (std::size_t i = 0; i < n; ++i) values[i] = workPoints_[order_[i]];
}

}  // namespace muster
