#include "assignment/dense/bottleneck_assignment.h"

#include <doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "base/random.h"

using muster::BottleneckSolver;
using muster::Random;
using muster::TransportationProblem;
using muster::TransportationSolution;
using muster::TransportationSolver;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Owned {
    std::int32_t rows = 0;
    std::int32_t columns = 0;
    std::vector<double> cost, supply, demand;
    TransportationProblem problem() const { return {rows, columns, cost, supply, demand}; }
};

// Costs of few different values, so that there are ties, and a share of pairs without a way.
Owned randomProblem(Random& random, std::int32_t rows, std::int32_t columns, std::uint32_t values,
                    double blocked) {
    Owned owned{rows, columns, {}, {}, {}};
    for (std::int32_t k = 0; k < rows * columns; ++k)
        owned.cost.push_back(random.uniform(0, 1) < blocked ? kInfinite
                                                            : static_cast<double>(random.below(values)));
    return owned;
}

// Over all ways to give rows to columns: as many pairs as possible, then the least dearest pair.
double byHand(const Owned& owned) {
    const std::int32_t size = std::max(owned.rows, owned.columns);
    std::vector<std::int32_t> order(static_cast<std::size_t>(size));
    std::iota(order.begin(), order.end(), 0);
    std::int32_t most = 0;
    double least = 0.0;
    do {
        std::int32_t pairs = 0;
        double dearest = 0.0;
        for (std::int32_t i = 0; i < owned.rows; ++i) {
            const std::int32_t j = order[i];
            if (j >= owned.columns) continue;
            const double c = owned.cost[i * owned.columns + j];
            if (c == kInfinite) continue;
            ++pairs;
            dearest = std::max(dearest, c);
        }
        if (pairs > most || (pairs == most && dearest < least)) {
            most = pairs;
            least = dearest;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

// What pairs up to `most` can carry: the optimum where they cost nothing and the others one.
double amountWithin(const Owned& owned, double most) {
    Owned bounded = owned;
    for (double& c : bounded.cost) c = c <= most ? 0.0 : kInfinite;
    TransportationSolver solver;
    TransportationSolution solution;
    REQUIRE(solver.solve(bounded.problem(), solution).ok());
    return solution.amount;
}

}  // namespace

TEST_CASE("the bottleneck is that of the best of all permutations") {
    Random random(4);
    BottleneckSolver solver;
    for (int k = 0; k < 150; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(6));
        const auto columns = static_cast<std::int32_t>(1 + random.below(6));
        const Owned owned = randomProblem(random, rows, columns, 2 + random.below(30),
                                          random.uniform(0, 0.7));
        CAPTURE(k);
        CHECK(solver.solve(owned.problem()) == byHand(owned));
    }
}

TEST_CASE("no cheaper bound carries as much, and the bound itself does") {
    Random random(5);
    BottleneckSolver solver;
    for (int k = 0; k < 12; ++k) {
        Owned owned = randomProblem(random, 30 + k, 44 - k, 400, 0.1 * (k % 8));
        if (k % 2 == 1) {
            for (std::int32_t i = 0; i < owned.rows; ++i) owned.supply.push_back(random.uniform(0, 3));
            for (std::int32_t j = 0; j < owned.columns; ++j)
                owned.demand.push_back(k % 4 == 1 ? 1.0 : random.uniform(0, 2));
            owned.supply[3] = owned.demand[2] = 0.0;
        }
        const double bound = solver.solve(owned.problem());
        const double all = amountWithin(owned, 1e9);
        CAPTURE(k);
        CHECK(amountWithin(owned, bound) == doctest::Approx(all).epsilon(1e-9));
        CHECK(amountWithin(owned, bound - 0.5) < all - 1e-6);
    }
}

TEST_CASE("nothing to match, one pair, a pair that nobody can use") {
    BottleneckSolver solver;
    CHECK(solver.solve({0, 0, {}, {}, {}}) == 0.0);
    const std::vector<double> none{kInfinite, kInfinite};
    CHECK(solver.solve({2, 1, none, {}, {}}) == 0.0);
    const std::vector<double> one{7.5};
    CHECK(solver.solve({1, 1, one, {}, {}}) == 7.5);
    // The second place can only be taken by the one who is far: as many as possible comes first.
    const std::vector<double> far{1.0, 90.0, 2.0, kInfinite};
    CHECK(solver.solve({2, 2, far, {}, {}}) == 90.0);
    const std::vector<double> idle{0.0, 1.0};
    CHECK(solver.solve({2, 2, far, idle, {}}) == 2.0);
}

TEST_CASE("a chain that has to shift as a whole") {
    // Row i can have column i for 1 and column i+1 for 2; the last column is the only one left for the last
    // row.
    constexpr std::int32_t n = 200;
    Owned owned{n, n, std::vector<double>(static_cast<std::size_t>(n * n), 50.0), {}, {}};
    for (std::int32_t i = 0; i < n; ++i) {
        owned.cost[i * n + i] = 1.0;
        owned.cost[i * n + (i + 1) % n] = 2.0;
    }
    BottleneckSolver solver;
    CHECK(solver.solve(owned.problem()) == 1.0);
    // The first has to take the second column, and so on round to the last, who takes the first.
    owned.cost[0] = 50.0;
    CHECK(solver.solve(owned.problem()) == 2.0);
    owned.cost[(n - 1) * n] = 50.0;
    CHECK(solver.solve(owned.problem()) == 50.0);
}
