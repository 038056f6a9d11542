// Dynamic assignment: cold start, and a step while tracking, with straight costs. A row of arcs and the
// duals of a node are about 270 bytes; a step reads them a few times, so it is bound by that traffic and by
// the searches.
#include <benchmark/benchmark.h>

#include <vector>

#include "base/random.h"
#include "engine/assignment/transport/dynamic/dynamic_assignment.h"

namespace {

using muster::Vec2;

class StraightCosts : public muster::CostOracle {
public:
    std::vector<Vec2> characters;
    std::vector<Vec2> places;
    float cost(std::int32_t i, std::int32_t j) override {
        return static_cast<float>(distance(characters[i], places[j]));
    }
    void evaluate(std::span<const muster::AssignmentPair> pairs, std::span<float> cost,
                  muster::ThreadPool&) override {
        for (std::size_t k = 0; k < pairs.size(); ++k)
            cost[k] = this->cost(pairs[k].character, pairs[k].place);
    }
};

// A block of places, 0.8 m apart, and the same block of characters `away` metres behind, each up to 0.3 m
// off.
StraightCosts blocks(std::int32_t n, double away) {
    muster::Random random(1);
    StraightCosts costs;
    std::int32_t columns = 1;
    while (columns * columns < n) ++columns;
    for (std::int32_t k = 0; k < n; ++k) {
        const Vec2 p{(k % columns) * 0.8, (k / columns) * 0.8};
        costs.places.push_back(p);
        costs.characters.push_back(p + Vec2{random.uniform(-0.3, 0.3) - away, random.uniform(-0.3, 0.3)});
    }
    return costs;
}

muster::DynamicAssignmentDef assignmentDef() {
    return {.threshold = 0.1, .thresholdShare = 0.001};
}

void dynamicAssignmentCold(benchmark::State& state) {
    StraightCosts costs = blocks(static_cast<std::int32_t>(state.range(0)), 40.0);
    muster::ThreadPool pool(1);
    muster::DynamicAssignment assignment;
    for (auto _ : state) {
        assignment.coldStart(assignmentDef(), {costs.characters, costs.places, {}, {}}, costs, pool);
        benchmark::DoNotOptimize(assignment.objective());
    }
    state.counters["gap_pct"] = 100.0 * assignment.dualityGap() / assignment.objective();
}

void dynamicAssignmentTracking(benchmark::State& state) {
    StraightCosts costs = blocks(static_cast<std::int32_t>(state.range(0)), 2.0);
    muster::ThreadPool pool(1);
    muster::DynamicAssignment assignment;
    assignment.coldStart(assignmentDef(), {costs.characters, costs.places, {}, {}}, costs, pool);
    double settled = 0.0;
    for (auto _ : state) {
        for (Vec2& p : costs.places) p += Vec2{1.5 / 60.0, 0.0};
        for (std::size_t i = 0; i < costs.characters.size(); ++i) {
            const Vec2 goal = costs.places[assignment.placeOf()[i]];
            costs.characters[i] += (goal - costs.characters[i]) * (1.0 / 80.0);
        }
        assignment.update(assignmentDef(), {costs.characters, costs.places, {}, {}}, costs, pool);
        settled += static_cast<double>(assignment.settled());
    }
    state.counters["settled"] = settled / static_cast<double>(state.iterations());
    state.counters["gap_pct"] = 100.0 * assignment.dualityGap() / assignment.objective();
}

}  // namespace

BENCHMARK(dynamicAssignmentCold)->Arg(160)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(dynamicAssignmentTracking)
    ->Arg(160)
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
