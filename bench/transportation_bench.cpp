// Benchmarks of the dense assignment solver and of the exact plan.
#include <benchmark/benchmark.h>

#include <limits>
#include <vector>

#include "base/random.h"
#include "engine/assignment/planning/fixed_costs.h"
#include "engine/assignment/planning/plan.h"

namespace {

using muster::Vec2;

std::vector<Vec2> block(std::int32_t n, Vec2 corner, double spacing) {
    std::int32_t columns = 1;
    while (columns * columns < n) ++columns;
    std::vector<Vec2> points;
    for (std::int32_t k = 0; k < n; ++k) {
        const std::int32_t row = k / columns;
        points.push_back(corner +
                         Vec2{static_cast<double>(k - row * columns), static_cast<double>(row)} * spacing);
    }
    return points;
}

std::vector<Vec2> scattered(std::int32_t n, double side) {
    muster::Random random(1);
    std::vector<Vec2> points;
    for (std::int32_t k = 0; k < n; ++k) points.push_back({random.uniform(0, side), random.uniform(0, side)});
    return points;
}

// Scattered characters, places in a block, squared distances; a share of pairs impossible, amounts 0.5
// and 1.5 or 1.
void assignment(benchmark::State& state, double forbidden, bool weighted) {
    const auto n = static_cast<std::int32_t>(state.range(0));
    const std::vector<Vec2> characters = scattered(n, 32.0);
    const std::vector<Vec2> places = block(n, {4, 4}, 0.8);
    muster::Random random(2);
    std::vector<double> cost;
    for (const Vec2 a : characters)
        for (const Vec2 b : places)
            cost.push_back(random.uniform() < forbidden ? std::numeric_limits<double>::infinity()
                                                        : lengthSquared(b - a));
    std::vector<double> supply;
    for (std::int32_t k = 0; weighted && k < n; ++k) supply.push_back(k % 2 ? 0.5 : 1.5);
    muster::TransportationSolver solver;
    muster::TransportationSolution solution;
    for (auto _ : state) {
        benchmark::DoNotOptimize(solver.solve({n, n, cost, supply, {}}, solution).ok());
        benchmark::DoNotOptimize(solution.cost);
    }
    state.counters["paths"] = solution.augmentations;
}

void assignmentUnits(benchmark::State& state) {
    assignment(state, 0.0, false);
}
void assignmentHalfForbidden(benchmark::State& state) {
    assignment(state, 0.5, false);
}
void assignmentAmounts(benchmark::State& state) {
    assignment(state, 0.0, true);
}

// 128 x 128 cells of 0.25 m with a wall of 8 m.
muster::UnitCost ground() {
    muster::UnitCost cost{.grid = muster::Grid::covering({{0, 0}, {32, 32}}, 0.25)};
    cost.cells.assign(static_cast<std::size_t>(cost.grid.count()), {});
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    for (std::int32_t y = 48; y < 80; ++y)
        for (std::int32_t x = 63; x < 66; ++x)
            cost.cells[cost.grid.index({x, y})] = {kInfinite, kInfinite, kInfinite, kInfinite};
    for (std::int32_t y = 48; y < 80; ++y) {
        cost.cells[cost.grid.index({62, y})].east = kInfinite;
        cost.cells[cost.grid.index({66, y})].west = kInfinite;
    }
    return cost;
}

// A block of characters moves to the same block `away` metres farther; one thread. With `incumbents` they
// hold their places already, else nobody holds one.
void exactPlan(benchmark::State& state, double away, bool incumbents) {
    const auto n = static_cast<std::int32_t>(state.range(0));
    const muster::UnitCost cost = ground();
    muster::FixedCosts costs;
    costs.unit = &cost;
    const std::vector<Vec2> characters = block(n, {6, 12}, 0.8);
    const std::vector<Vec2> places = block(n, {6 + away, 12}, 0.8);
    std::vector<std::int32_t> incumbent(characters.size(), -1);
    for (std::int32_t k = 0; incumbents && k < n; ++k) incumbent[k] = k;
    const auto plan = muster::makeExactPlan();
    muster::ThreadPool pool(1);
    muster::PlanResult result;
    for (auto _ : state) {
        benchmark::DoNotOptimize(plan->start({}, {characters, {}, places, {}, {}, incumbent, &costs}).ok());
        benchmark::DoNotOptimize(plan->finish(pool, result).ok());
    }
    state.counters["objective"] = result.objective;
}

void exactPlanFirst(benchmark::State& state) {
    exactPlan(state, 12.0, false);
}
void exactPlanFar(benchmark::State& state) {
    exactPlan(state, 12.0, true);
}
void exactPlanFollowing(benchmark::State& state) {
    exactPlan(state, 1.0, true);
}

}  // namespace

BENCHMARK(assignmentUnits)->Arg(36)->Arg(100)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(assignmentHalfForbidden)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(assignmentAmounts)->Arg(100)->Arg(400)->Unit(benchmark::kMillisecond);
BENCHMARK(exactPlanFirst)->Arg(36)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(exactPlanFar)->Arg(36)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(exactPlanFollowing)->Arg(36)->Arg(100)->Unit(benchmark::kMillisecond);
