// A symmetric positive definite sparse system, factorised once and solved many times.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "muster/vec2.h"

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
    /// Two right sides at once, as x and y: each gets the very solution it would get alone.
    void solve(std::vector<Vec2>& values);
    /// Number of unknowns.
    int size() const { return static_cast<int>(diagonal_.size()); }

private:
    void findPairs();

    std::vector<int> order_;   ///< Position of each unknown in the factor.
    std::vector<int> start_;   ///< Where each column of L begins; unit diagonal left out.
    std::vector<int> paired_;  ///< From where on a column's rows come two by two, one just after the other.
    std::vector<int> row_;
    std::vector<double> value_;
    std::vector<double> diagonal_;
    std::vector<double> work_;
    std::vector<Vec2> workPoints_;
};

}  // namespace muster
