// Benchmarks of cost fields, unit cost and density.
#include <benchmark/benchmark.h>

#include "base/random.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"

namespace {

using namespace muster;

enum Scene : std::int64_t { Open, Block, Corridor, Crowd };
const char* const kNames[] = {"open", "block", "corridor", "crowd"};

ObstacleDef rectangle(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

Environment makeEnvironment(std::int64_t scene, std::int64_t cells) {
    EnvironmentDef def;
    const double half = 0.125 * static_cast<double>(cells);
    def.box = {{-half, -half}, {half, half}};
    Environment environment = std::move(Environment::create(def)).value();
    if (scene == Block)
        (void)environment.addObstacle(rectangle(-0.3 * half, -0.25 * half, 0.3 * half, 0.2 * half));
    if (scene == Corridor) {
        (void)environment.addObstacle(rectangle(-0.1 * half, -half, 0.1 * half, -1.0));
        (void)environment.addObstacle(rectangle(-0.1 * half, 1.0, 0.1 * half, half));
    }
    environment.setTime(0.0);
    return environment;
}

// 100 characters in a block round `centre`, 0.7 m apart, walking east.
void crowdOf100(Vec2 centre, std::vector<Vec2>& positions, std::vector<Vec2>& velocities) {
    for (int k = 0; k < 100; ++k)
        positions.push_back(centre + Vec2{0.7 * (k % 10) - 3.15, 0.7 * (k / 10) - 3.15});
    velocities.assign(positions.size(), Vec2{1.4, 0.0});
}

UnitCost makeCost(const Environment& environment, std::int64_t scene) {
    DensityField density(environment.def().box, {});
    std::vector<Vec2> positions;
    std::vector<Vec2> velocities;
    if (scene == Crowd) {
        crowdOf100({0, 0}, positions, velocities);
        density.splat(positions, velocities);
    }
    UnitCostBuilder builder;
    UnitCost cost;
    builder.build({}, environment, density, 0.25, cost);
    return cost;
}

void wholeField(benchmark::State& state) {
    const Environment environment = makeEnvironment(state.range(0), state.range(1));
    const UnitCost cost = makeCost(environment, state.range(0));
    EikonalSolver solver;
    CostField field;
    const double quarter = 0.5 * environment.def().box.max.x;
    for (auto _ : state) {
        solver.solve(cost, {-quarter, 0.1}, {}, field);
        benchmark::DoNotOptimize(field.acceptedCount());
    }
    state.SetLabel(kNames[state.range(0)]);
    state.counters["cells"] = field.acceptedCount();
}
BENCHMARK(wholeField)
    ->ArgsProduct({{Open, Block, Corridor, Crowd}, {128, 256}})
    ->Unit(benchmark::kMillisecond);

// A plan's work: a field per place of a block of 100, each marched until it meets the 100 characters.
void hundredFields(benchmark::State& state) {
    const Environment environment = makeEnvironment(state.range(0), 128);
    const UnitCost cost = makeCost(environment, state.range(0));
    std::vector<Vec2> places;
    std::vector<Vec2> characters;
    std::vector<Vec2> velocities;
    crowdOf100({-9, 0}, characters, velocities);
    crowdOf100({9, 0}, places, velocities);
    EikonalSolver solver;
    std::vector<CostField> fields(places.size());
    for (auto _ : state) {
        for (std::size_t k = 0; k < places.size(); ++k) solver.solve(cost, places[k], characters, fields[k]);
    }
    state.SetLabel(kNames[state.range(0)]);
}
BENCHMARK(hundredFields)->Arg(Open)->Arg(Block)->Arg(Corridor)->Arg(Crowd)->Unit(benchmark::kMillisecond);

void densitySplat(benchmark::State& state) {
    DensityField density({{-64, -64}, {64, 64}}, {});
    Random random(1);
    std::vector<Vec2> positions(static_cast<std::size_t>(state.range(0)));
    for (Vec2& p : positions) p = {random.uniform(-20, 20), random.uniform(-20, 20)};
    const std::vector<Vec2> velocities(positions.size(), Vec2{1, 0});
    for (auto _ : state) density.splat(positions, velocities);
}
BENCHMARK(densitySplat)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

void unitCost(benchmark::State& state) {
    const Environment environment = makeEnvironment(Block, state.range(0));
    DensityField density(environment.def().box, {});
    std::vector<Vec2> positions;
    std::vector<Vec2> velocities;
    crowdOf100({-0.5 * environment.def().box.max.x, 0}, positions, velocities);
    density.splat(positions, velocities);
    UnitCostBuilder builder;
    UnitCost cost;
    for (auto _ : state) builder.build({}, environment, density, 0.25, cost);
}
BENCHMARK(unitCost)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

// The same with a car that moves every step, so that the unit cost changes.
void unitCostMoving(benchmark::State& state) {
    Environment environment = makeEnvironment(Block, state.range(0));
    ObstacleDef car = rectangle(-1.0, -0.5, 1.0, 0.5);
    car.path.waypoints = {{0.0, {-10, 10}, 0.0}, {10.0, {10, 10}, 0.0}};
    car.path.loop = true;
    (void)environment.addObstacle(car);
    UnitCostBuilder builder;
    UnitCost cost;
    double time = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        environment.setTime(time += 1.0 / 60.0);
        state.ResumeTiming();
        builder.build({}, environment, DensityField(), 0.25, cost);
    }
}
BENCHMARK(unitCostMoving)->Arg(128)->Arg(512)->Unit(benchmark::kMillisecond);

}  // namespace
