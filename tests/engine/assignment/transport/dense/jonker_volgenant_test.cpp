#include "engine/assignment/transport/dense/jonker_volgenant.h"

#include <doctest.h>

#include <algorithm>
#include <numeric>

#include "engine/assignment/transport/dense/successive_shortest_paths.h"
#include "engine/assignment/transport/dense/transportation_checks.h"

using namespace muster;
using muster_test::kInfinite;
using muster_test::OwnedProblem;

TEST_CASE("an assignment costs as much as successive shortest paths with unit amounts") {
    Random random(41);
    JonkerVolgenantSolver assignment;
    SuccessiveShortestPaths paths;
    const std::vector<double> ones(40, 1.0);
    for (int k = 0; k < 40; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(30));
        const std::int32_t columns = rows + static_cast<std::int32_t>(k % 2 == 0 ? 0 : random.below(10));
        const OwnedProblem problem = muster_test::randomProblem(random, rows, columns, 50, 0.0, 0);
        REQUIRE(assignment.solve(rows, columns, problem.cost.data()));
        REQUIRE(paths.solve(rows, columns, problem.cost.data(), std::span(ones).first(rows),
                            std::span(ones).first(columns), 1e-12));
        double byAssignment = 0.0;
        double byPaths = 0.0;
        double dual = std::accumulate(assignment.rowDual().begin(), assignment.rowDual().end(), 0.0);
        for (const double v : assignment.columnDual()) dual += v;
        for (std::int32_t i = 0; i < rows; ++i) {
            byAssignment += problem.at(i, assignment.columnOf()[i]);
            for (std::int32_t j = 0; j < columns; ++j) byPaths += problem.at(i, j) * paths.flow(i, j);
        }
        CHECK(byAssignment == byPaths);
        CHECK(dual == byAssignment);
    }
}

TEST_CASE("where not every row can have a column, the solver says so") {
    JonkerVolgenantSolver assignment;
    const std::vector<double> cost{1, kInfinite, 2, kInfinite};
    CHECK_FALSE(assignment.solve(2, 2, cost.data()));
    CHECK(std::count(assignment.columnOf().begin(), assignment.columnOf().end(), -1) == 1);
    SuccessiveShortestPaths paths;
    const std::vector<double> ones(2, 1.0);
    CHECK_FALSE(paths.solve(2, 2, cost.data(), ones, ones, 1e-12));
    CHECK(paths.flow(0, 0) + paths.flow(1, 0) == 1.0);
}
