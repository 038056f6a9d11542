#include "engine/assignment/transport/dense/dulmage_mendelsohn.h"

#include <doctest.h>

#include "engine/assignment/transport/dense/transportation_checks.h"

using namespace muster;
using muster_test::kInfinite;
using muster_test::OwnedProblem;
using Part = DulmageMendelsohnPart;

namespace {

double supplied(const OwnedProblem& problem) {
    TransportationSolution solution;
    REQUIRE(TransportationSolver().solve(problem.view(), solution).ok());
    return solution.amount;
}

}  // namespace

TEST_CASE("two rows for one column, a pair, and one row for two columns are the three parts") {
    const double x = kInfinite;
    const std::vector<double> cost{1, x, x, x,   // Rows 0 and 1 share column 0.
                                   1, x, x, x,   //
                                   1, 1, x, x,   // Row 2 has column 1 for itself.
                                   1, 1, 1, 1};  // Row 3 has columns 2 and 3.
    const std::vector<double> ones(4, 1.0);
    DulmageMendelsohn decomposition;
    decomposition.decompose(4, 4, cost.data(), ones, ones, 1e-12);
    CHECK(decomposition.rowPart() ==
          std::vector{Part::Vertical, Part::Vertical, Part::Square, Part::Horizontal});
    CHECK(decomposition.columnPart() ==
          std::vector{Part::Vertical, Part::Square, Part::Horizontal, Part::Horizontal});
}

TEST_CASE("no largest transport needs a pair that joins two parts") {
    Random random(31);
    DulmageMendelsohn decomposition;
    for (int k = 0; k < 60; ++k) {
        OwnedProblem problem = muster_test::randomProblem(random, 12, 14, 9, 0.85, k % 2 ? 3 : 1);
        decomposition.decompose(12, 14, problem.cost.data(), problem.supply, problem.demand, 1e-12);
        const double all = supplied(problem);
        for (std::int32_t i = 0; i < 12; ++i)
            for (std::int32_t j = 0; j < 14; ++j) {
                const Part row = decomposition.rowPart()[i];
                const Part column = decomposition.columnPart()[j];
                // No possible pair leads out of the vertical part, or from the square into the horizontal
                // one.
                if (problem.at(i, j) < kInfinite) CHECK(row >= column);
                if (row != column) problem.cost[i * 14 + j] = kInfinite;
            }
        CHECK(supplied(problem) == all);
    }
}
