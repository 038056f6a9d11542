// Sparse L D L^T factorisation of symmetric positive definite systems, which are then solved many times.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// One entry of a sparse matrix.
using SparseEntry = Eigen::Triplet<double, int>;

/// Eigen factorises, with a fill-reducing order; substitution is done here in reused memory, because Eigen's
/// solve() allocates.
class SparseLdlt {
public:
    /// Factorises the matrix given by its entries (both triangles; repeated entries add up). False where it
    /// is not positive definite.
    bool factorise(int size, const std::vector<SparseEntry>& entries);
    /// Replaces `values`, the right side, by the solution.
    void solve(std::vector<double>& values);
    /// Replaces two right sides at once, as x and y; each gets the same bits as alone.
    void solve(std::vector<Vec2>& values);
    /// Number of unknowns.
    int size() const { return static_cast<int>(diagonal_.size()); }

private:
    void findPairs();

    std::vector<int> order_;        // Position of each unknown in the factor.
    std::vector<int> start_;        // First entry of each column of L; the unit diagonal is not stored.
    std::vector<int> paired_;       // First entry of each column from which rows come in consecutive pairs.
    std::vector<int> row_;          // Row of each entry.
    std::vector<double> value_;     // Value of each entry.
    std::vector<double> diagonal_;  // Diagonal D.
    std::vector<double> work_;      // Right side and solution in the factor's order.
    std::vector<Vec2> workPoints_;  // Right side and solution for two right sides.
};

}  // namespace muster
