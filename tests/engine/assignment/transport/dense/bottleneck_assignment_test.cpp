#include "engine/assignment/transport/dense/bottleneck_assignment.h"

#include <doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "base/random.h"
#include "engine/assignment/transport/dense/transportation_checks.h"

using muster::BottleneckSolver;
using muster::Random;
using muster::TransportationSolution;
using muster::TransportationSolver;
using muster_test::kInfinite;
using muster_test::OwnedProblem;
using muster_test::randomProblem;

namespace {

// Over all matchings: as many pairs as possible, then the least cost of the most expensive pair.
double enumerated(const OwnedProblem& owned) {
    const std::int32_t size = std::max(owned.rows, owned.columns);
    std::vector<std::int32_t> order(static_cast<std::size_t>(size));
    std::iota(order.begin(), order.end(), 0);
    std::int32_t most = 0;
    double least = 0.0;
    do {
        std::int32_t pairs = 0;
        double largest = 0.0;
        for (std::int32_t i = 0; i < owned.rows; ++i) {
            const std::int32_t j = order[i];
            if (j >= owned.columns) continue;
            const double c = owned.cost[i * owned.columns + j];
            if (c == kInfinite) continue;
            ++pairs;
            largest = std::max(largest, c);
        }
        if (pairs > most || (pairs == most && largest < least)) {
            most = pairs;
            least = largest;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

// What the pairs of cost up to `threshold` can send.
double amountWithin(const OwnedProblem& owned, double threshold) {
    OwnedProblem bounded = owned;
    for (double& c : bounded.cost) c = c <= threshold ? 0.0 : kInfinite;
    TransportationSolver solver;
    TransportationSolution solution;
    REQUIRE(solver.solve(bounded.view(), solution).ok());
    return solution.amount;
}

}  // namespace

TEST_CASE("the bottleneck is that of the best of all permutations") {
    Random random(4);
    BottleneckSolver solver;
    for (int k = 0; k < 150; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(6));
        const auto columns = static_cast<std::int32_t>(1 + random.below(6));
        const OwnedProblem owned = randomProblem(random, rows, columns, 2 + random.below(30),
                                                 random.uniform(0, 0.7), 0);
        CAPTURE(k);
        CHECK(solver.solve(owned.view()) == enumerated(owned));
    }
}

TEST_CASE("pairs up to the bottleneck send as much as all, and pairs below it do not") {
    Random random(5);
    BottleneckSolver solver;
    for (int k = 0; k < 12; ++k) {
        OwnedProblem owned = randomProblem(random, 30 + k, 44 - k, 400, 0.1 * (k % 8), 0);
        if (k % 2 == 1) {
            for (std::int32_t i = 0; i < owned.rows; ++i) owned.supply.push_back(random.uniform(0, 3));
            for (std::int32_t j = 0; j < owned.columns; ++j)
                owned.demand.push_back(k % 4 == 1 ? 1.0 : random.uniform(0, 2));
            owned.supply[3] = owned.demand[2] = 0.0;
        }
        const double bound = solver.solve(owned.view());
        const double all = amountWithin(owned, 1e9);
        CAPTURE(k);
        CHECK(amountWithin(owned, bound) == doctest::Approx(all).epsilon(1e-9));
        CHECK(amountWithin(owned, bound - 0.5) < all - 1e-6);
    }
}

TEST_CASE("nothing to match, one pair, an impossible pair") {
    BottleneckSolver solver;
    CHECK(solver.solve({0, 0, {}, {}, {}}) == 0.0);
    const std::vector<double> none{kInfinite, kInfinite};
    CHECK(solver.solve({2, 1, none, {}, {}}) == 0.0);
    const std::vector<double> one{7.5};
    CHECK(solver.solve({1, 1, one, {}, {}}) == 7.5);
    // Only the first row can have the second column, at a high cost: as many pairs as possible come first.
    const std::vector<double> far{1.0, 90.0, 2.0, kInfinite};
    CHECK(solver.solve({2, 2, far, {}, {}}) == 90.0);
    const std::vector<double> idle{0.0, 1.0};
    CHECK(solver.solve({2, 2, far, idle, {}}) == 2.0);
}

TEST_CASE("a cycle of two hundred rows that has to shift as a whole") {
    // Row i can have column i for 1 and column i + 1 for 2.
    constexpr std::int32_t n = 200;
    OwnedProblem owned{n, n, std::vector<double>(static_cast<std::size_t>(n * n), 50.0), {}, {}};
    for (std::int32_t i = 0; i < n; ++i) {
        owned.cost[i * n + i] = 1.0;
        owned.cost[i * n + (i + 1) % n] = 2.0;
    }
    BottleneckSolver solver;
    CHECK(solver.solve(owned.view()) == 1.0);
    // The first row has to take the second column, and so on to the last row, which takes the first column.
    owned.cost[0] = 50.0;
    CHECK(solver.solve(owned.view()) == 2.0);
    owned.cost[(n - 1) * n] = 50.0;
    CHECK(solver.solve(owned.view()) == 50.0);
}
