// Random problems, and checks that every solution must pass.
#pragma once

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/random.h"
#include "engine/assignment/transport/dense/transportation_problem.h"

namespace muster_test {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A problem that owns its numbers.
struct OwnedProblem {
    std::int32_t rows = 0;
    std::int32_t columns = 0;
    std::vector<double> cost;
    std::vector<double> supply;
    std::vector<double> demand;

    double at(std::int32_t i, std::int32_t j) const { return cost[i * columns + j]; }
    double supplyOf(std::int32_t i) const { return supply.empty() ? 1.0 : supply[i]; }
    double demandOf(std::int32_t j) const { return demand.empty() ? 1.0 : demand[j]; }
    muster::TransportationProblem view() const { return {rows, columns, cost, supply, demand}; }
};

/// Whole-number costs in [0, range); a share `forbidden` of the pairs is impossible; amounts in [0,
/// mostAmount] where that is over 0, else units.
inline OwnedProblem randomProblem(muster::Random& random, std::int32_t rows, std::int32_t columns,
                                  std::uint32_t range, double forbidden, std::uint32_t mostAmount) {
    OwnedProblem problem{rows, columns, {}, {}, {}};
    for (std::int32_t k = 0; k < rows * columns; ++k) {
        const double cost = random.below(range);
        problem.cost.push_back(random.uniform() < forbidden ? kInfinite : cost);
    }
    if (mostAmount > 0) {
        for (std::int32_t i = 0; i < rows; ++i) problem.supply.push_back(random.below(mostAmount + 1));
        for (std::int32_t j = 0; j < columns; ++j) problem.demand.push_back(random.below(mostAmount + 1));
    }
    return problem;
}

/// Points in a square, costs their distance to the power 2.
inline OwnedProblem geometricProblem(muster::Random& random, std::int32_t rows, std::int32_t columns) {
    OwnedProblem problem{rows, columns, {}, {}, {}};
    std::vector<double> x;
    for (std::int32_t k = 0; k < 2 * (rows + columns); ++k) x.push_back(random.uniform(0.0, 32.0));
    for (std::int32_t i = 0; i < rows; ++i)
        for (std::int32_t j = 0; j < columns; ++j) {
            const double dx = x[2 * i] - x[2 * (rows + j)];
            const double dy = x[2 * i + 1] - x[2 * (rows + j) + 1];
            problem.cost.push_back(dx * dx + dy * dy);
        }
    return problem;
}

/// Flows are within the amounts, the duals prove the optimum (u + v <= cost, equal where something flows),
/// and the sums are as stated.
inline void checkSolution(const OwnedProblem& problem, const muster::TransportationSolution& solution) {
    double scale = 1.0;
    for (const double c : problem.cost)
        if (c < kInfinite) scale = std::max(scale, c);
    const double tolerance = 1e-9 * scale;
    std::vector<double> sent(problem.rows, 0.0);
    std::vector<double> filled(problem.columns, 0.0);
    double amount = 0.0;
    double cost = 0.0;
    double worstComplementarity = 0.0;
    bool ordered = true;
    for (std::size_t k = 0; k < solution.flows.size(); ++k) {
        const muster::Flow& flow = solution.flows[k];
        REQUIRE(flow.amount > 0.0);
        REQUIRE(problem.at(flow.character, flow.place) < kInfinite);
        sent[flow.character] += flow.amount;
        filled[flow.place] += flow.amount;
        amount += flow.amount;
        cost += flow.amount * problem.at(flow.character, flow.place);
        const double reduced = problem.at(flow.character, flow.place) - solution.rowDual[flow.character] -
                               solution.columnDual[flow.place];
        worstComplementarity = std::max(worstComplementarity, std::abs(reduced));
        if (k == 0) continue;
        const muster::Flow& before = solution.flows[k - 1];
        ordered = ordered && (before.character < flow.character ||
                              (before.character == flow.character && before.place < flow.place));
    }
    CHECK(ordered);
    CHECK(amount == doctest::Approx(solution.amount).epsilon(1e-12));
    CHECK(cost == doctest::Approx(solution.cost).epsilon(1e-12));
    CHECK(worstComplementarity <= tolerance);
    bool within = true;
    for (std::int32_t i = 0; i < problem.rows; ++i) within = within && sent[i] <= problem.supplyOf(i) + 1e-9;
    for (std::int32_t j = 0; j < problem.columns; ++j)
        within = within && filled[j] <= problem.demandOf(j) + 1e-9;
    CHECK(within);
    double worstReducedCost = 0.0;
    for (std::int32_t i = 0; i < problem.rows; ++i)
        for (std::int32_t j = 0; j < problem.columns; ++j)
            worstReducedCost = std::max(worstReducedCost,
                                        solution.rowDual[i] + solution.columnDual[j] - problem.at(i, j));
    CHECK(worstReducedCost <= tolerance);
}

}  // namespace muster_test
