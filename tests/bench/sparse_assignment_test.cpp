// The judges' own assignment against the plans' solver.
#include <doctest.h>

#include <limits>

#include "base/random.h"
#include "engine/assignment/transport/dense/transportation_problem.h"
#include "scale/sparse_assignment.h"

using namespace muster;
using namespace muster::scale;

namespace {

struct Problem {
    std::vector<std::vector<Arc>> rows;
    std::vector<double> dense;  // rows x columns; infinite where there is no arc.
    std::int32_t columns = 0;
};

Problem randomProblem(std::int32_t rows, std::int32_t columns, double share, bool whole, Random& random) {
    Problem problem{.columns = columns};
    problem.rows.resize(rows);
    problem.dense.assign(static_cast<std::size_t>(rows) * columns, std::numeric_limits<double>::infinity());
    for (std::int32_t r = 0; r < rows; ++r)
        for (std::int32_t c = 0; c < columns; ++c) {
            // One arc each is certain, so that all can be matched.
            if (c != r && random.uniform() > share) continue;
            const double cost = whole ? static_cast<double>(random.below(4)) : random.uniform(0, 10);
            problem.rows[r].push_back({c, cost});
            problem.dense[static_cast<std::size_t>(r) * columns + c] = cost;
        }
    return problem;
}

double costOf(const Problem& problem, const std::vector<std::int32_t>& columnOf) {
    double sum = 0.0;
    for (std::size_t r = 0; r < columnOf.size(); ++r) sum += problem.dense[r * problem.columns + columnOf[r]];
    return sum;
}

}  // namespace

TEST_CASE("matches at the same cost as the transport solver, and its duals prove it") {
    Random random(5);
    SparseAssignment solver;
    TransportationSolver dense;
    for (int trial = 0; trial < 120; ++trial) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(30));
        const auto columns = rows + static_cast<std::int32_t>(trial % 3 == 0 ? random.below(8) : 0);
        const Problem problem = randomProblem(rows, columns, random.uniform(0.02, 1.0), trial % 2 == 0,
                                              random);
        std::vector<double> start;
        if (rows == columns && trial % 4 == 1)
            for (std::int32_t c = 0; c < columns; ++c) start.push_back(random.uniform(-9, 9));
        REQUIRE(solver.solve(problem.rows, columns, start));
        TransportationSolution solution;
        REQUIRE(dense.solve({rows, columns, problem.dense, {}, {}}, solution).ok());
        CHECK(costOf(problem, solver.columnOf()) == doctest::Approx(solution.cost).epsilon(1e-9));
        // The dual objective is a bound that weak duality proves; it must meet the cost.
        double dual = 0.0;
        for (const double v : solver.duals()) dual += v;
        for (const std::vector<Arc>& arcs : problem.rows) {
            double least = std::numeric_limits<double>::infinity();
            for (const Arc& arc : arcs) least = std::min(least, arc.cost - solver.duals()[arc.column]);
            dual += least;
        }
        CHECK(dual == doctest::Approx(solution.cost).epsilon(1e-9));
    }
}

TEST_CASE("with more columns than rows no dual is above zero, and those of unmatched columns are zero") {
    Random random(7);
    SparseAssignment solver;
    const Problem problem = randomProblem(12, 20, 0.5, false, random);
    REQUIRE(solver.solve(problem.rows, 20, {}));
    std::vector<bool> taken(20, false);
    for (const std::int32_t c : solver.columnOf()) taken[c] = true;
    for (std::size_t c = 0; c < 20; ++c)
        CHECK((taken[c] ? solver.duals()[c] <= 0.0 : solver.duals()[c] == 0.0));
}

TEST_CASE("says where not all rows can be matched") {
    const std::vector<std::vector<Arc>> rows{{{0, 1.0}}, {{0, 2.0}}, {{1, 1.0}}};
    SparseAssignment solver;
    CHECK_FALSE(solver.solve(rows, 3, {}));
    const std::vector<std::vector<Arc>> empty{{}};
    CHECK_FALSE(solver.solve(empty, 1, {}));
    CHECK(solver.columnOf()[0] == -1);
}
