// Benchmarks of kernels with the memory that each must touch and a lower bound of its time by that.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

#include "base/neighbour_list.h"
#include "base/random.h"
#include "base/stopwatch.h"
#include "engine/assignment/planning/fixed_costs.h"
#include "engine/assignment/planning/plan.h"
#include "engine/assignment/transport/dense/transportation_problem.h"
#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/formation/mesh/arap.h"
#include "engine/formation/shapes/make_formation.h"

namespace {

using namespace muster;

// Bytes per second of a = b + s c, the best of some rounds: streams of `bytes` in total, once measured and
// kept.
double triad(std::size_t bytes) {
    const std::size_t count = bytes / (3 * sizeof(double));
    std::vector<double> a(count, 0.0);
    std::vector<double> b(count, 1.0);
    std::vector<double> c(count, 2.0);
    const std::size_t repeats = std::max<std::size_t>(1, (std::size_t{64} << 20) / bytes);
    double best = 0.0;
    for (int round = 0; round < 12; ++round) {
        const Stopwatch watch;
        for (std::size_t k = 0; k < repeats; ++k) {
            for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 3.0 * c[i];
            benchmark::DoNotOptimize(a.data());
            benchmark::ClobberMemory();
        }
        best = std::max(best, static_cast<double>(bytes * repeats) / (1e-3 * watch.milliseconds()));
    }
    return best;
}

// A working set that fits the second-level cache is bound by that, a larger one by memory.
double bandwidthFor(double bytes) {
    static const double memory = triad(std::size_t{64} << 20);
    static const double cache = triad(std::size_t{256} << 10);
    return bytes <= (1 << 20) ? cache : memory;
}

/// Times the loop of a benchmark and writes its counters: gigabytes per second measured, megabytes that must
/// be read or written once, milliseconds of the bound and of the kernel, and how many times the bound that
/// is.
class Bound {
public:
    Bound(benchmark::State& state, double bytes)
        : state_(state), bytes_(bytes), speed_(bandwidthFor(bytes)), began_(std::clock()) {}
    ~Bound() {
        const double whole = 1e3 * static_cast<double>(std::clock() - began_) / CLOCKS_PER_SEC;
        const double each = whole /
                            static_cast<double>(std::max<benchmark::IterationCount>(1, state_.iterations()));
        const double bound = 1e3 * bytes_ / speed_;
        state_.counters["GB_per_s"] = 1e-9 * speed_;
        state_.counters["MB"] = 1e-6 * bytes_;
        state_.counters["bound_ms"] = bound;
        state_.counters["ms"] = each;
        state_.counters["times_bound"] = each / bound;
    }
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;

private:
    benchmark::State& state_;
    double bytes_;
    double speed_;
    std::clock_t began_;  // Of the processor, whatever else the machine does.
};

UnitCost openGround(std::int64_t cells) {
    UnitCost cost;
    const double half = 0.125 * static_cast<double>(cells);
    cost.grid = Grid::covering({{-half, -half}, {half, half}}, 0.25);
    cost.cells.assign(static_cast<std::size_t>(cost.grid.count()), {});
    // Random unit costs, so that no cheapest path is a straight line.
    Random random(3);
    for (CellCost& c : cost.cells) {
        const auto value = static_cast<float>(random.uniform(1.0, 1.5));
        c = {value, value, value, value};
    }
    return cost;
}

std::vector<Vec2> rows(std::int64_t count, Vec2 first, double spacing) {
    const auto across = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    std::vector<Vec2> points;
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t column = k % across, row = k / across;
        points.push_back(first +
                         Vec2{spacing * static_cast<double>(column), spacing * static_cast<double>(row)});
    }
    return points;
}

// A field is written once, and its unit cost read once.
void oneField(benchmark::State& state) {
    const UnitCost cost = openGround(state.range(0));
    EikonalSolver solver;
    CostField field;
    solver.solve(cost, {0.1, 0.1}, {}, field);
    const Bound bound(state, cost.grid.count() * (sizeof(CellCost) + sizeof(float)));
    for (auto _ : state) {
        solver.solve(cost, {0.1, 0.1}, {}, field);
        benchmark::DoNotOptimize(field.acceptedCount());
    }
}

// A field for each of so many places, one after the other: batched, the unit cost need be read only once for
// all.
void manyFields(benchmark::State& state) {
    const UnitCost cost = openGround(256);
    const std::vector<Vec2> places = rows(state.range(0), {-8, -8}, 1.0);
    EikonalSolver solver;
    std::vector<CostField> fields(places.size());
    const Bound bound(
        state, cost.grid.count() * (sizeof(CellCost) + sizeof(float) * static_cast<double>(places.size())));
    for (auto _ : state)
        for (std::size_t k = 0; k < places.size(); ++k) solver.solve(cost, places[k], {}, fields[k]);
}

// Scattered characters, places in rows, squared distances, nobody has a place: the costs are read once.
void assignmentCold(benchmark::State& state) {
    const auto n = static_cast<std::int32_t>(state.range(0));
    Random random(1);
    std::vector<double> cost;
    const std::vector<Vec2> places = rows(n, {0, 0}, 1.0);
    for (std::int32_t i = 0; i < n; ++i) {
        const Vec2 p{random.uniform(0, std::sqrt(n)), random.uniform(0, std::sqrt(n))};
        for (const Vec2 q : places) cost.push_back(lengthSquared(q - p));
    }
    TransportationSolver solver;
    TransportationSolution solution;
    const Bound bound(state, static_cast<double>(cost.size()) * sizeof(double));
    for (auto _ : state) {
        benchmark::DoNotOptimize(solver.solve({n, n, cost, {}, {}}, solution).ok());
        benchmark::DoNotOptimize(solution.cost);
    }
}

// A crowd 2 m behind its places, in a thin wood: a post between every fourth of them, in both directions.
struct Following {
    explicit Following(std::int64_t n);

    Environment environment;
    UnitCost cost;
    StaticGround ground;
    DynamicCost dynamicCost;
    std::vector<Vec2> characters;
    std::vector<Vec2> places;
    std::vector<std::int32_t> incumbent;
};

Following::Following(std::int64_t n) {
    const double side = std::sqrt(static_cast<double>(n));
    const Vec2 first{-0.5 * side, -0.5 * side};
    characters = rows(n, first - Vec2{2.0, 0.0}, 1.0);
    places = rows(n, first, 1.0);
    for (std::size_t k = 0; k < places.size(); ++k) incumbent.push_back(static_cast<std::int32_t>(k));
    EnvironmentDef def{.box = {{-0.5 * side - 8.0, -0.5 * side - 8.0}, {0.5 * side + 8.0, 0.5 * side + 8.0}}};
    environment = Environment::create(def).value();
    for (double y = 2.5; y < side; y += 4.0)
        for (double x = 2.5; x < side; x += 4.0)
            (void)environment.addObstacle({.centre = first + Vec2{x, y}, .radius = 0.35});
    environment.setTime(0.0);
    DensityField density(def.box, {});
    density.splat(characters, std::vector<Vec2>(characters.size(), Vec2{1.2, 0.0}));
    UnitCostBuilder().build({}, environment, density, 0.25, cost);
    ground.update(environment, 1.0, 0.25);
    dynamicCost.update({}, environment, density, 0.25);
}

// It plans again, its places 0.02 m to and fro. The bound is one read of the unit cost of the ground that it
// stands on, of all positions, and of 16 arcs each.
void assignmentWarm(benchmark::State& state, std::unique_ptr<Plan> (*make)()) {
    const std::int64_t n = state.range(0);
    Following crowd(n);
    FixedCosts costs;
    costs.unit = &crowd.cost;
    costs.still = &crowd.ground;
    costs.changing = &crowd.dynamicCost;
    const auto plan = make();
    ThreadPool pool(1);
    PlanResult result;
    const auto again = [&](double by) {
        for (Vec2& place : crowd.places) place.x += by;
        const PlanInput input{crowd.characters, {}, crowd.places, {}, {}, crowd.incumbent, &costs};
        if (!plan->start({}, input).ok() || !plan->finish(pool, result).ok()) return false;
        for (const Flow& flow : result.flows) crowd.incumbent[flow.character] = flow.place;
        return true;
    };
    bool well = true;
    for (int k = 0; k < 20; ++k) well = again(k % 2 == 0 ? 0.02 : -0.02) && well;
    if (!well || result.flows.size() != crowd.places.size()) {
        state.SkipWithError("the plan was refused");
        return;
    }
    double by = -0.02;
    const double side = std::sqrt(static_cast<double>(n)) + 4.0;
    const Bound bound(state, side * side * 16.0 * sizeof(CellCost) +
                                 static_cast<double>(n) * (2 * sizeof(Vec2) + 16 * sizeof(float)));
    for (auto _ : state) well = again(by = -by) && well;
    state.counters["changed"] = result.reassigned;
}

// One solve of the mesh of a square formation with two constrained corners: vertices and triangles are read,
// in each of its iterations, and vertices written.
void meshSolve(benchmark::State& state) {
    const Formation formation = makeFormation({}, static_cast<std::int32_t>(state.range(0))).value();
    ArapSolver solver;
    const std::vector<Vec2>& rest = formation.mesh.vertices;
    const std::vector<std::int32_t> constrained{0, static_cast<std::int32_t>(rest.size()) - 1};
    if (!solver.setMesh(formation.mesh).ok() || !solver.setConstraints(constrained, {}).ok()) {
        state.SkipWithError("the mesh was refused");
        return;
    }
    std::vector<Vec2> moved(rest);
    std::vector<Vec2> targets{rest.front() + Vec2{0.1, 0.0}, rest.back() + Vec2{0.0, 0.1}};
    const Bound bound(state,
                      static_cast<double>(rest.size()) * 2 * sizeof(Vec2) +
                          static_cast<double>(formation.mesh.triangles.size()) * 3 * sizeof(std::int32_t));
    for (auto _ : state) {
        targets[0].x = -targets[0].x;
        benchmark::DoNotOptimize(solver.solve(targets, {}, moved).ok());
    }
    state.counters["vertices"] = static_cast<double>(rest.size());
}

// Pairs nearer than 1 m in a crowd of one a square metre: positions are read, pairs written.
void neighbourSearch(benchmark::State& state) {
    const double side = std::sqrt(static_cast<double>(state.range(0)));
    Random random(2);
    std::vector<Vec2> positions(static_cast<std::size_t>(state.range(0)));
    for (Vec2& p : positions) p = {random.uniform(0, side), random.uniform(0, side)};
    NeighbourList list;
    list.build(positions, 1.0);
    const Bound bound(state, static_cast<double>(positions.size()) * sizeof(Vec2) +
                                 static_cast<double>(list.pairs().size()) * sizeof(NeighbourPair));
    for (auto _ : state) list.build(positions, 1.0);
    state.counters["pairs"] = static_cast<double>(list.pairs().size());
}

}  // namespace

BENCHMARK(oneField)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(manyFields)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(assignmentCold)->Arg(160)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assignmentWarm, exact, makeExactPlan)->Arg(160)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assignmentWarm, fast, makeFastPlan)
    ->Arg(160)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(meshSolve)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(neighbourSearch)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
