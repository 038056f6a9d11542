// Amounts and totals against an independent solver: LEMON's network simplex on whole numbers.
#include <doctest.h>

#if __has_include(<lemon/network_simplex.h>)
#define MUSTER_HAS_LEMON 1
#include <lemon/network_simplex.h>
#include <lemon/smart_graph.h>
#else
#define MUSTER_HAS_LEMON 0
#endif

#include "engine/assignment/transport/dense/transportation_checks.h"

#if MUSTER_HAS_LEMON

namespace {

using muster_test::OwnedProblem;

struct Total {
    long long amount = 0;
    long long cost = 0;
};

// What is not sent goes to the sink at a penalty beyond all that an exchange can save, so that as much as
// possible is sent, and that at least cost.
Total solveWithLemon(const OwnedProblem& problem) {
    using Graph = lemon::SmartDigraph;
    Graph graph;
    Graph::NodeMap<long long> supply(graph);
    Graph::ArcMap<long long> cost(graph);
    Graph::ArcMap<long long> capacity(graph);
    constexpr long long kUnlimited = 1LL << 40;
    const Graph::Node sink = graph.addNode();
    std::vector<Graph::Node> rows(problem.rows);
    std::vector<Graph::Node> columns(problem.columns);
    long long largestCost = 0;
    long long supplied = 0;
    const auto addArc = [&](Graph::Node a, Graph::Node b, long long unitCost, long long most) {
        const Graph::Arc arc = graph.addArc(a, b);
        cost[arc] = unitCost;
        capacity[arc] = most;
    };
    for (auto& node : columns) node = graph.addNode();
    for (std::int32_t j = 0; j < problem.columns; ++j)
        addArc(columns[j], sink, 0, static_cast<long long>(problem.demandOf(j)));
    for (std::int32_t i = 0; i < problem.rows; ++i) {
        rows[i] = graph.addNode();
        supply[rows[i]] = static_cast<long long>(problem.supplyOf(i));
        supplied += supply[rows[i]];
        for (std::int32_t j = 0; j < problem.columns; ++j) {
            if (!(problem.at(i, j) < muster_test::kInfinite)) continue;
            addArc(rows[i], columns[j], static_cast<long long>(problem.at(i, j)), kUnlimited);
            largestCost = std::max(largestCost, static_cast<long long>(problem.at(i, j)));
        }
    }
    const long long penalty = (largestCost + 1) * (problem.rows + problem.columns + 2);
    for (const auto& node : rows) addArc(node, sink, penalty, kUnlimited);
    supply[sink] = -supplied;
    lemon::NetworkSimplex<Graph, long long, long long> simplex(graph);
    simplex.supplyMap(supply).costMap(cost).upperMap(capacity);
    REQUIRE(simplex.run() == simplex.OPTIMAL);
    Total total{supplied, simplex.totalCost<long long>()};
    for (Graph::OutArcIt arc(graph, sink); arc != lemon::INVALID; ++arc) FAIL("the sink has an outgoing arc");
    for (Graph::InArcIt arc(graph, sink); arc != lemon::INVALID; ++arc) {
        if (cost[arc] != penalty) continue;
        total.amount -= simplex.flow(arc);
        total.cost -= simplex.flow(arc) * penalty;
    }
    return total;
}

void compare(muster::TransportationSolver& solver, const OwnedProblem& problem) {
    muster::TransportationSolution solution;
    REQUIRE(solver.solve(problem.view(), solution).ok());
    const Total expected = solveWithLemon(problem);
    CHECK(solution.amount == static_cast<double>(expected.amount));
    CHECK(solution.cost == static_cast<double>(expected.cost));
    muster_test::checkSolution(problem, solution);
}

}  // namespace

TEST_CASE("assignment problems equal LEMON: ties, rectangles, impossible pairs") {
    muster::Random random(1987);
    muster::TransportationSolver solver;
    const std::uint32_t ranges[] = {1, 3, 10, 1000, 1000000};
    const double forbidden[] = {0.0, 0.3, 0.7, 0.93};
    for (int k = 0; k < 900; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(24));
        const auto columns = static_cast<std::int32_t>(k % 3 == 0 ? rows : 1 + random.below(24));
        CAPTURE(k);
        compare(solver,
                muster_test::randomProblem(random, rows, columns, ranges[k % 5], forbidden[(k / 5) % 4], 0));
    }
    MESSAGE("900 assignment problems: totals as LEMON's");
}

TEST_CASE("transportation problems equal LEMON: ties, rectangles, impossible pairs, zero amounts") {
    muster::Random random(1963);
    muster::TransportationSolver solver;
    const std::uint32_t ranges[] = {1, 4, 50, 100000};
    const double forbidden[] = {0.0, 0.4, 0.8, 0.93};
    const std::uint32_t most[] = {1, 2, 7, 1000};
    for (int k = 0; k < 600; ++k) {
        const auto rows = static_cast<std::int32_t>(1 + random.below(20));
        const auto columns = static_cast<std::int32_t>(1 + random.below(20));
        CAPTURE(k);
        compare(solver, muster_test::randomProblem(random, rows, columns, ranges[k % 4],
                                                   forbidden[(k / 4) % 4], most[(k / 16) % 4]));
    }
    MESSAGE("600 transportation problems: totals as LEMON's");
}

TEST_CASE("larger problems equal LEMON") {
    muster::Random random(7);
    muster::TransportationSolver solver;
    for (const std::int32_t n : {100, 150, 200}) {
        compare(solver, muster_test::randomProblem(random, n, n, 1000000, 0.0, 0));
        compare(solver, muster_test::randomProblem(random, n, n, 20, 0.97, 0));
        compare(solver, muster_test::randomProblem(random, n, n - 17, 500, 0.1, 9));
        OwnedProblem geometric = muster_test::geometricProblem(random, n, n + 5);
        for (double& c : geometric.cost) c = std::floor(c * 1000.0);
        compare(solver, geometric);
    }
}

#else

TEST_CASE("transportation problems equal LEMON") {
    MESSAGE("skipped: liblemon-dev is not installed");
}

#endif
