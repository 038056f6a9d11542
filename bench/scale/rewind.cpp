#include "scale/rewind.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "scale/case.h"
#include "scale/drag.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr std::int32_t kSteps = 8;         // Of a window.
constexpr std::int32_t kFirstSteps = 120;  // Steps that are not measured.
constexpr std::int32_t kEditAt = 3;        // Step of a window with an edit.

/// What is measured of each window [ms].
struct Times {
    std::vector<double> first, again, ratio, over, rewind, snapshot, restored;
};

/// Steps a world through a window; CPU time of its steps [ms].
Result<double> window(const RewindDef& def, World& world, Drag& drag) {
    double sum = 0.0;
    for (std::int32_t s = 0; s < kSteps; ++s) {
        if (def.scene.regime != Regime::Far)
            if (Status status = drag.before(world); !status.ok()) return status;
        if (def.edits && s == kEditAt) {
            ObstacleDef building;
            const Vec2 at = world.group(0).pose.position + Vec2{3.0, 1.0};
            building.polygon = {at, at + Vec2{2, 0}, at + Vec2{2, 2}, at + Vec2{0, 2}};
            if (Status status = world.submit({world.stepCount(), 900, 0, putThing(building)}); !status.ok())
                return status;
        }
        sum += timedStep(world);
    }
    return sum;
}

Status differs(const char* what, std::uint32_t step) {
    return {StatusCode::Corrupt,
            std::string(what) + " ended step " + std::to_string(step) + " in another state"};
}

/// The same window in a world that is restored afresh.
Status measureRestore(const RewindDef& def, const std::vector<std::uint8_t>& bytes, Drag drag,
                      std::uint64_t hash, Times& times) {
    const double began = threadMilliseconds();
    Result<World> world = World::restore(bytes);
    const double took = threadMilliseconds() - began;
    if (!world.ok()) return world.status();
    const Result<double> steps = window(def, *world, drag);
    if (!steps.ok()) return steps.status();
    times.restored.push_back(took + *steps);
    return world->hash() == hash ? Status() : differs("a restored world", world->stepCount());
}

Status measureWindow(const RewindDef& def, World& world, Drag& drag, Times& times, std::size_t& size) {
    double began = threadMilliseconds();
    const std::vector<std::uint8_t> bytes = world.snapshot();
    times.snapshot.push_back(threadMilliseconds() - began);
    size = bytes.size();
    const Drag then = drag;
    const Result<double> first = window(def, world, drag);
    if (!first.ok()) return first.status();
    const std::uint64_t hash = world.hash();
    began = threadMilliseconds();
    if (Status status = world.rewind(bytes); !status.ok()) return status;
    const double rewind = threadMilliseconds() - began;
    Drag repeated = then;
    const Result<double> again = window(def, world, repeated);
    if (!again.ok()) return again.status();
    if (world.hash() != hash) return differs("a rewound world", world.stepCount());
    times.first.push_back(*first);
    times.rewind.push_back(rewind);
    times.again.push_back(rewind + *again);
    times.ratio.push_back((rewind + *again) / std::max(*first, 1e-6));
    times.over.push_back(rewind + *again - 1.25 * *first);
    return measureRestore(def, bytes, then, hash, times);
}

RewindRow rowOf(const Times& times) {
    return {.windows = static_cast<std::int32_t>(times.first.size()),
            .first50 = quantile(times.first, 0.5),
            .again50 = quantile(times.again, 0.5),
            .ratio50 = quantile(times.ratio, 0.5),
            .ratio95 = quantile(times.ratio, 0.95),
            .over95 = quantile(times.over, 0.95),
            .rewind50 = quantile(times.rewind, 0.5),
            .rewind95 = quantile(times.rewind, 0.95),
            .snapshot50 = quantile(times.snapshot, 0.5),
            .restored50 = quantile(times.restored, 0.5),
            .restored95 = quantile(times.restored, 0.95)};
}

}  // namespace

Result<RewindRow> measureRewind(const RewindDef& def) {
    const Result<Scene> scene = makeScene(def.scene);
    if (!scene.ok()) return scene.status();
    CaseDef one{.scene = def.scene, .plan = "fast"};
    Result<World> world = makeWorld(one, *scene);
    if (!world.ok()) return world.status();
    Drag drag(scene->course, scene->side);
    Times times;
    std::size_t bytes = 0;
    const auto steps = static_cast<std::uint32_t>(def.seconds / world->parameters().stepTime);
    while (world->stepCount() < kFirstSteps) {
        if (const Result<double> warm = window({def.scene, def.seconds, false}, *world, drag); !warm.ok())
            return warm.status();
    }
    while (world->stepCount() < steps)
        if (Status status = measureWindow(def, *world, drag, times, bytes); !status.ok()) return status;
    RewindRow row = rowOf(times);
    row.bytes = bytes;
    row.hash = world->hash();
    return row;
}

std::string rewindText(const RewindDef& def, const RewindRow& row) {
    std::array<char, 512> text{};
    std::snprintf(
        text.data(), text.size(),
        "%s %s, %d characters%s: 8 steps p50 %.2f ms, back and forward p50 %.2f ms, ratio p50 %.2f p95 "
        "%.2f, over 1.25 times p95 %.2f ms; rewind p50 %.2f p95 %.2f ms, snapshot p50 %.2f ms (%zu bytes); "
        "restore and 8 steps p50 %.2f p95 %.2f ms; %d windows, hash %016llx\n",
        def.scene.name.c_str(), regimeName(def.scene.regime), def.scene.count, def.edits ? " with edits" : "",
        row.first50, row.again50, row.ratio50, row.ratio95, row.over95, row.rewind50, row.rewind95,
        row.snapshot50, row.bytes, row.restored50, row.restored95, row.windows,
        static_cast<unsigned long long>(row.hash));
    return text.data();
}

}  // namespace muster::scale
