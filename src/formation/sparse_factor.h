// A symmetric positive definite sparse system, factorised once and solved many times.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

namespace muster {

/// One entry of a sparse matrix.
using SparseEntry = Eigen::Triplet<double, int>;

/// L D L^T with a fill-reducing order. Solving uses own substitution on reused memory, because
/// Eigen's solve() makes temporaries.
class SparseFactor {
public:
    /// Factorises the matrix given by its entries (both triangles; repeated ones add up).
    /// False where it is not positive definite.
    bool factorise(int size, const std::vector<SparseEntry>& entries);
    /// Replaces `values` (the right side) by the solution.
    void solve(std::vector<double>& values);
    /// Number of unknowns.
    int size() const { return static_cast<int>(diagonal_.size()); }

private:
    std::vector<int> order_;     ///< Position of each unknown in the factor.
    std::vector<int> start_;     ///< Where each column of L begins; unit diagonal left out.
    std::vector<int> row_;
    std::vector<double> value_;
    std::vector<double> diagonal_;
    std::vector<double> work_;
};

}  // namespace muster
