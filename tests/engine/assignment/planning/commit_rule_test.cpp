#include "engine/assignment/planning/commit_rule.h"

#include <doctest.h>

#include "engine/assignment/transport/dense/transportation_checks.h"

namespace {

using muster::CommitRule;
using muster::Flow;
using muster::PlanDef;

std::vector<Flow> flowsOf(const std::vector<std::int32_t>& places) {
    std::vector<Flow> flows;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(places.size()); ++i)
        if (places[i] >= 0) flows.push_back({i, places[i], 1.0});
    return flows;
}

std::vector<std::int32_t> commit(const PlanDef& def, std::int32_t places, const std::vector<double>& cost,
                                 const std::vector<std::int32_t>& incumbent,
                                 const std::vector<std::int32_t>& optimal) {
    CommitRule rule;
    std::vector<Flow> committed;
    const auto characters = static_cast<std::int32_t>(incumbent.size());
    const auto costOf = [&](std::int32_t i, std::int32_t j) {
        return muster::FlowCost{cost[i * places + j]};
    };
    rule.choose(def, characters, places, costOf, flowsOf(incumbent), flowsOf(optimal), committed);
    std::vector<std::int32_t> result(incumbent.size(), -1);
    for (const Flow& flow : committed) result[flow.character] = flow.place;
    return result;
}

PlanDef withThreshold(double threshold, double share) {
    return {.commitThreshold = threshold, .commitThresholdShare = share};
}

using Places = std::vector<std::int32_t>;

}  // namespace

TEST_CASE("each cycle is committed by its own gain") {
    // Characters 0 and 1 gain 4 by exchanging, characters 2 and 3 gain 0.05.
    const std::vector<double> cost = {3, 1, 9, 9, 1, 3, 9, 9, 9, 9, 1.025, 1, 9, 9, 1, 1.025};
    const Places incumbent = {0, 1, 2, 3};
    const Places best = {1, 0, 3, 2};
    CHECK(commit(withThreshold(0.1, 0.0), 4, cost, incumbent, best) == Places{1, 0, 2, 3});
    CHECK(commit(withThreshold(0.0, 0.0), 4, cost, incumbent, best) == best);
    CHECK(commit(withThreshold(5.0, 0.0), 4, cost, incumbent, best) == incumbent);
}

TEST_CASE("the threshold share is of the objective of the characters concerned") {
    // The exchange takes the pair from 6 to 2: two thirds.
    const std::vector<double> cost = {3, 1, 99, 1, 3, 99, 99, 99, 50};
    const Places incumbent = {0, 1, 2};
    const Places best = {1, 0, 2};
    CHECK(commit(withThreshold(0.0, 0.6), 3, cost, incumbent, best) == best);
    CHECK(commit(withThreshold(0.0, 0.7), 3, cost, incumbent, best) == incumbent);
}

TEST_CASE("a tie keeps the incumbents") {
    const std::vector<double> cost = {1, 1, 1, 1};
    CHECK(commit(withThreshold(0.0, 0.0), 2, cost, {1, 0}, {0, 1}) == Places{1, 0});
}

TEST_CASE("an exchange that matches one more is always committed") {
    // A path: character 2 has no place, character 1 must make room for it and move to place 2.
    const std::vector<double> cost = {1, 99, 99, 99, 1, 50, 99, 1, 99};
    CHECK(commit(withThreshold(1e6, 1.0), 3, cost, {0, 1, -1}, {0, 2, 1}) == Places{0, 2, 1});
}

TEST_CASE("paths that match no more are committed for their gain only") {
    // Character 0 moves to the unused place 1.
    const std::vector<double> move = {5, 3};
    CHECK(commit(withThreshold(1.0, 0.0), 2, move, {0}, {1}) == Places{1});
    CHECK(commit(withThreshold(3.0, 0.0), 2, move, {0}, {1}) == Places{0});
    // Character 1, unmatched, would take over the place of character 0.
    const std::vector<double> takeOver = {5, 3};
    CHECK(commit(withThreshold(1.0, 0.0), 1, takeOver, {0, -1}, {-1, 0}) == Places{-1, 0});
    CHECK(commit(withThreshold(3.0, 0.0), 1, takeOver, {0, -1}, {-1, 0}) == Places{0, -1});
}

TEST_CASE("fractional flows that share a character or place are one exchange") {
    const std::vector<Flow> incumbent = {{0, 0, 1.0}, {1, 1, 1.0}};
    const std::vector<Flow> best = {{0, 0, 0.5}, {0, 1, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}};
    const std::vector<double> cost = {4, 2, 2, 4};
    CommitRule rule;
    std::vector<Flow> committed;
    const auto costOf = [&](std::int32_t i, std::int32_t j) { return muster::FlowCost{cost[i * 2 + j]}; };
    rule.choose(withThreshold(1.9, 0.0), 2, 2, costOf, incumbent, best, committed);
    CHECK(committed.size() == 4);
    rule.choose(withThreshold(2.1, 0.0), 2, 2, costOf, incumbent, best, committed);
    CHECK(committed.size() == 2);
}

TEST_CASE(
    "random: what is committed is feasible, as large as the best, and no worse than the threshold allows") {
    muster::Random random(31);
    muster::TransportationSolver solver;
    for (int k = 0; k < 300; ++k) {
        const auto rows = static_cast<std::int32_t>(2 + random.below(12));
        const auto columns = static_cast<std::int32_t>(2 + random.below(12));
        const auto problem = muster_test::randomProblem(random, rows, columns, 40, (k % 3) * 0.25, 0);
        Places incumbent(rows, -1);
        std::vector<bool> taken(columns, false);
        for (std::int32_t i = 0; i < rows; ++i) {
            const auto j = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(columns)));
            if (taken[j] || !(problem.at(i, j) < muster_test::kInfinite)) continue;
            taken[j] = true;
            incumbent[i] = j;
        }
        muster::TransportationSolution solution;
        REQUIRE(solver.solve(problem.view(), solution).ok());
        const double threshold = random.below(30);
        std::vector<Flow> committed;
        const auto costOf = [&](std::int32_t i, std::int32_t j) {
            return muster::FlowCost{problem.at(i, j)};
        };
        CommitRule().choose(withThreshold(threshold, 0.0), rows, columns, costOf, flowsOf(incumbent),
                            solution.flows, committed);
        double amount = 0.0, cost = 0.0;
        std::vector<int> used(columns, 0);
        for (const Flow& flow : committed) {
            CHECK(++used[flow.place] == 1);
            amount += flow.amount;
            cost += flow.amount * problem.at(flow.character, flow.place);
        }
        CHECK(amount == solution.amount);
        CHECK(cost >= solution.cost);
        // At most half as many exchanges as characters and places were dropped, each for no more than the
        // threshold.
        CHECK(cost - solution.cost <= threshold * 0.5 * (rows + columns));
        if (threshold == 0.0) CHECK(cost == solution.cost);
    }
}
