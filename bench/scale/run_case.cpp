#include <algorithm>

#include "base/stopwatch.h"
#include "muster/parameter_table.h"
#include "scale/case.h"
#include "scale/drag.h"
#include "scale/meter.h"

namespace muster::scale {
namespace {

constexpr double kArrived = 0.5;          // Distance to its place within which a character has arrived [m].
constexpr std::int32_t kWarmUp = 120;     // Least number of steps in which memory may grow.
constexpr std::uint32_t kLookEvery = 30;  // Steps between checks whether the crowd has arrived.

// Measurements of a run.
struct Watch {
    std::vector<double> cpu;   // Per step [ms].
    std::vector<double> wall;  // Per step [ms].
    std::array<double, kStageCount> stages{};
    std::int64_t allocations = 0;
    std::uint64_t swaps = 0;
    double lag = 0.0;
};

void timedStep(World& world, bool warm, Watch& watch) {
    const std::int64_t before = allocationCount();
    const Stopwatch wall;
    const double began = threadMilliseconds();
    world.step();
    const double cpu = threadMilliseconds() - began;
    const double whole = wall.milliseconds();
    if (warm) watch.allocations += allocationCount() - before;
    watch.cpu.push_back(cpu);
    watch.wall.push_back(whole);
    for (std::size_t k = 0; k < watch.stages.size(); ++k)
        if (watch.wall.size() > 1) watch.stages[k] += world.stageTimes().milliseconds[k];
    for (const Event& event : world.events()) watch.swaps += event.kind == EventKind::Swap ? 1 : 0;
}

// Distances to places: their mean, and the share of those that are near enough.
void lags(const World& world, double& mean, double& arrived) {
    const CharactersView characters = world.characters();
    const std::span<const Vec2> places = world.group(0).placePositions;
    double sum = 0.0;
    std::int32_t near = 0;
    std::int32_t matched = 0;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        if (characters.place[i] < 0) continue;
        const double lag = distance(characters.position[i], places[characters.place[i]]);
        sum += lag;
        near += lag <= kArrived ? 1 : 0;
        ++matched;
    }
    mean = matched > 0 ? sum / matched : 0.0;
    arrived = matched > 0 ? static_cast<double>(near) / matched : 0.0;
}

void fill(const Watch& watch, Row& row) {
    // With one thread the CPU time is that of the step alone and does not depend on other processes.
    const std::vector<double>& all = row.def.threads == 1 ? watch.cpu : watch.wall;
    row.cold = all.front();
    const std::vector<double> rest(all.begin() + 1, all.end());
    row.steps = static_cast<std::int32_t>(rest.size());
    row.p50 = quantile(rest, 0.5);
    row.p95 = quantile(rest, 0.95);
    row.max = quantile(rest, 1.0);
    row.wallP95 = quantile({watch.wall.begin() + 1, watch.wall.end()}, 0.95);
    for (std::size_t k = 0; k < row.stages.size(); ++k)
        row.stages[k] = watch.stages[k] / std::max(1, row.steps);
    row.allocations = allocationsCounted() ? watch.allocations : -1;
    row.lagMean = watch.lag / static_cast<double>(all.size());
}

}  // namespace

Result<World> makeWorld(const CaseDef& def, const Scene& scene) {
    WorldDef world = scene.world;
    const Status chosen = setParameter(world.parameters, "plan.solver", def.plan == "fast" ? 1.0 : 0.0);
    if (!chosen.ok() && def.plan != "exact")
        return invalidArgument("found plan '" + def.plan + "', this build has exact only");
    return World::create(world, def.threads);
}

Result<Row> runCase(const CaseDef& def, const Observer& observer) {
    resetPeakMemory();
    const Result<Scene> scene = makeScene(def.scene);
    if (!scene.ok()) return scene.status();
    Result<World> made = makeWorld(def, *scene);
    if (!made.ok()) return made.status();
    World& world = *made;
    Drag drag(scene->course, scene->side);
    Watch watch;
    const double seconds = def.seconds > 0.0 ? def.seconds : scene->seconds;
    const auto most = std::max(2, static_cast<std::int32_t>(seconds / world.parameters().stepTime));
    const std::int32_t warmUp = std::min(std::max(kWarmUp, most / 3), most / 2);
    Row row{.def = def};
    for (std::int32_t step = 0; step < most; ++step) {
        if (def.scene.regime != Regime::Far)
            if (Status status = drag.before(world); !status.ok()) return status;
        timedStep(world, step >= warmUp, watch);
        if (observer) observer(world);
        double lag = 0.0;
        lags(world, lag, row.arrived);
        watch.lag += lag;
        if (def.scene.regime == Regime::Far && world.stepCount() % kLookEvery == 0 && row.arrived == 1.0)
            break;
    }
    fill(watch, row);
    row.swaps = static_cast<double>(watch.swaps) / (def.scene.count * world.time());
    row.hash = world.hash();
    row.memory = peakMemory();
    return row;
}

}  // namespace muster::scale
