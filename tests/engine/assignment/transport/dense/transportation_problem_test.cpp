#include "engine/assignment/transport/dense/transportation_problem.h"

#include <doctest.h>

#include <rapidcheck.h>
#include <numeric>

#include "engine/assignment/transport/dense/transportation_checks.h"

namespace {

using muster::Flow;
using muster::StatusCode;
using muster::TransportationSolution;
using muster::TransportationSolver;
using muster_test::kInfinite;
using muster_test::OwnedProblem;

TransportationSolution solved(const OwnedProblem& problem) {
    TransportationSolver solver;
    TransportationSolution solution;
    REQUIRE(solver.solve(problem.view(), solution).ok());
    muster_test::checkSolution(problem, solution);
    return solution;
}

std::vector<std::int32_t> placesOf(const OwnedProblem& problem, const TransportationSolution& solution) {
    std::vector<std::int32_t> places(problem.rows, -1);
    for (const Flow& flow : solution.flows) places[flow.character] = flow.place;
    return places;
}

// The best of all matchings, most pairs first, by enumeration.
std::pair<int, double> enumerate(const OwnedProblem& problem, std::int32_t row, std::vector<bool>& taken) {
    if (row == problem.rows) return {0, 0.0};
    auto best = enumerate(problem, row + 1, taken);
    for (std::int32_t j = 0; j < problem.columns; ++j) {
        if (taken[j] || !(problem.at(row, j) < kInfinite)) continue;
        taken[j] = true;
        auto with = enumerate(problem, row + 1, taken);
        taken[j] = false;
        ++with.first;
        with.second += problem.at(row, j);
        if (with.first > best.first || (with.first == best.first && with.second < best.second)) best = with;
    }
    return best;
}

}  // namespace

TEST_CASE("problems without rows or columns") {
    for (const auto& [rows, columns] : {std::pair{0, 0}, {0, 3}, {3, 0}}) {
        const TransportationSolution solution = solved({rows, columns, {}, {}, {}});
        CHECK(solution.flows.empty());
        CHECK(solution.amount == 0.0);
        CHECK(solution.cost == 0.0);
        CHECK(solution.rowDual.size() == static_cast<std::size_t>(rows));
        CHECK(solution.columnDual.size() == static_cast<std::size_t>(columns));
    }
}

TEST_CASE("small problems with known optima") {
    // The greedy choice (row 0 to column 0) costs 1 + 100; the best is 2 + 2.
    const OwnedProblem greedyFails{2, 2, {1, 2, 2, 100}, {}, {}};
    CHECK(solved(greedyFails).cost == 4.0);
    // Row 1 can only have column 0, so row 0 takes the other one, although that is expensive.
    const OwnedProblem forced{2, 2, {1, 50, 9, kInfinite}, {}, {}};
    const TransportationSolution solution = solved(forced);
    CHECK(solution.amount == 2.0);
    CHECK(solution.cost == 59.0);
    // Two rows for one column: the cheaper takes it.
    CHECK(placesOf({2, 1, {5, 3}, {}, {}}, solved({2, 1, {5, 3}, {}, {}})) ==
          std::vector<std::int32_t>{-1, 0});
    // A row without a possible column.
    const OwnedProblem isolated{2, 2, {kInfinite, kInfinite, 7, 4}, {}, {}};
    CHECK(placesOf(isolated, solved(isolated)) == std::vector<std::int32_t>{-1, 1});
}

TEST_CASE("squared distances on a line keep the order") {
    // Monge property: with a convex cost of the distance on a line the sorted matching is the optimum.
    muster::Random random(3);
    for (int round = 0; round < 20; ++round) {
        const std::int32_t n = 40;
        std::vector<double> x, y;
        for (std::int32_t k = 0; k < n; ++k) {
            x.push_back(random.uniform(0, 100));
            y.push_back(random.uniform(0, 100));
        }
        OwnedProblem problem{n, n, {}, {}, {}};
        for (const double a : x)
            for (const double b : y) problem.cost.push_back((a - b) * (a - b));
        const double cost = solved(problem).cost;
        std::sort(x.begin(), x.end());
        std::sort(y.begin(), y.end());
        double expected = 0.0;
        for (std::int32_t k = 0; k < n; ++k) expected += (x[k] - y[k]) * (x[k] - y[k]);
        CHECK(cost == doctest::Approx(expected).epsilon(1e-12));
    }
}

TEST_CASE("small assignment problems equal the best of all permutations") {
    muster::Random random(11);
    for (int k = 0; k < 400; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(k % 40 == 0 ? 7 : 5));
        const auto columns = static_cast<std::int32_t>(1 + random.below(k % 40 == 0 ? 7 : 5));
        const OwnedProblem problem = muster_test::randomProblem(random, rows, columns, k % 2 ? 4u : 100u,
                                                                (k % 4) * 0.25, 0);
        const TransportationSolution solution = solved(problem);
        std::vector<bool> taken(columns, false);
        const auto best = enumerate(problem, 0, taken);
        CHECK(solution.amount == best.first);
        CHECK(solution.cost == best.second);
    }
}

TEST_CASE("the duals prove the optimum where all pairs are possible") {
    muster::Random random(5);
    for (int k = 0; k < 60; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(30));
        const auto columns = static_cast<std::int32_t>(1 + random.below(30));
        OwnedProblem problem = muster_test::geometricProblem(random, rows, columns);
        if (k % 2) {
            for (std::int32_t i = 0; i < rows; ++i) problem.supply.push_back(random.uniform(0.0, 3.0));
            for (std::int32_t j = 0; j < columns; ++j) problem.demand.push_back(random.uniform(0.0, 3.0));
        }
        const TransportationSolution solution = solved(problem);
        double supplied = 0.0, demanded = 0.0, bound = 0.0;
        for (std::int32_t i = 0; i < rows; ++i) {
            supplied += problem.supplyOf(i);
            bound += problem.supplyOf(i) * solution.rowDual[i];
        }
        for (std::int32_t j = 0; j < columns; ++j) {
            demanded += problem.demandOf(j);
            bound += problem.demandOf(j) * solution.columnDual[j];
        }
        CHECK(solution.amount == doctest::Approx(std::min(supplied, demanded)).epsilon(1e-9));
        CHECK(bound == doctest::Approx(solution.cost).epsilon(1e-9));
    }
}

TEST_CASE("ties fall to the lower index, and equal problems have equal solutions") {
    for (const auto& [rows, columns] : {std::pair{6, 6}, {4, 7}, {7, 4}}) {
        const OwnedProblem same{
            rows, columns, std::vector<double>(static_cast<std::size_t>(rows * columns), 2.0), {}, {}};
        const std::vector<std::int32_t> places = placesOf(same, solved(same));
        for (std::int32_t i = 0; i < rows; ++i) CHECK(places[i] == (i < columns ? i : -1));
    }
    muster::Random random(17);
    TransportationSolver reused;
    for (int k = 0; k < 50; ++k) {
        const OwnedProblem problem = muster_test::randomProblem(random, 20, 22, 3, 0.2, k % 2 ? 4 : 0);
        TransportationSolution first, second;
        REQUIRE(reused.solve(problem.view(), first).ok());
        REQUIRE(TransportationSolver().solve(problem.view(), second).ok());
        REQUIRE(first.flows.size() == second.flows.size());
        for (std::size_t f = 0; f < first.flows.size(); ++f) {
            CHECK(first.flows[f].place == second.flows[f].place);
            CHECK(first.flows[f].amount == second.flows[f].amount);
        }
        CHECK(first.rowDual == second.rowDual);
        CHECK(first.columnDual == second.columnDual);
    }
}

TEST_CASE("equal amounts other than one") {
    muster::Random random(23);
    OwnedProblem problem = muster_test::randomProblem(random, 9, 9, 100, 0.0, 0);
    const double units = solved(problem).cost;
    problem.supply.assign(9, 0.25);
    problem.demand.assign(9, 0.25);
    CHECK(solved(problem).cost == doctest::Approx(0.25 * units).epsilon(1e-12));
}

TEST_CASE("amounts that do not add up exactly in binary") {
    // 0.1 + 0.2 is not 0.3: the remainder must not start another search.
    const OwnedProblem problem{2, 1, {1.0, 2.0}, {0.1, 0.2}, {0.3}};
    const TransportationSolution solution = solved(problem);
    CHECK(solution.amount == doctest::Approx(0.3).epsilon(1e-12));
    CHECK(solution.cost == doctest::Approx(0.5).epsilon(1e-12));
    muster::Random random(29);
    for (int k = 0; k < 100; ++k) {
        OwnedProblem fractions = muster_test::randomProblem(random, 12, 12, 5, k % 2 * 0.5, 9);
        for (double& amount : fractions.supply) amount *= 0.1;
        for (double& amount : fractions.demand) amount /= 30.0;
        solved(fractions);
    }
}

TEST_CASE("bad input is refused by name") {
    TransportationSolver solver;
    TransportationSolution solution;
    const auto message = [&](const OwnedProblem& problem) {
        const muster::Status status = solver.solve(problem.view(), solution);
        CHECK(status.code() == StatusCode::InvalidArgument);
        return status.message();
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(message({2, 2, {1, 2, 3}, {}, {}}) == "cost has 3 values, expected 4");
    CHECK(message({2, 2, {1, 2, -3, 4}, {}, {}}) == "cost of row 1, column 0 is negative or not a number");
    CHECK(message({2, 2, {1, nan, 3, 4}, {}, {}}) == "cost of row 0, column 1 is negative or not a number");
    CHECK(message({1, 1, {1}, {1, 1}, {}}) == "supply has 2 values, expected 1");
    CHECK(message({1, 2, {1, 1}, {}, {1, -1}}) == "demand 1 is not a finite number >= 0");
    CHECK(message({1, 1, {1}, {kInfinite}, {}}) == "supply 0 is not a finite number >= 0");
    CHECK(message({-1, 1, {}, {}, {}}) == "rows or columns are negative");
}

TEST_CASE("property: adding a constant to a row of a square problem changes the total by just that") {
    const bool passed = rc::check("shift", [] {
        const auto n = *rc::gen::inRange(1, 12);
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        muster::Random random(seed);
        OwnedProblem problem = muster_test::randomProblem(random, n, n, 50, 0.0, 0);
        const auto total = [](const OwnedProblem& p) {
            TransportationSolution solution;
            RC_ASSERT(TransportationSolver().solve(p.view(), solution).ok());
            return solution.cost;
        };
        const double before = total(problem);
        const auto row = *rc::gen::inRange(0, n);
        for (std::int32_t j = 0; j < n; ++j) problem.cost[row * n + j] += 13.0;
        RC_ASSERT(total(problem) == before + 13.0);
    });
    CHECK(passed);
}
