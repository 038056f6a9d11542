// The step of a world: a table of stages, each of which reads what the stages before it have written.
#include <iterator>

#include "base/stopwatch.h"
#include "engine/systems/commands/apply_commands.h"
#include "engine/systems/events/event_stage.h"
#include "engine/systems/mesh/mesh_stages.h"
#include "engine/world/world_engine.h"

namespace muster {
namespace {

using StageFunction = void (*)(WorldEngine&);

// In the order of Stage.
constexpr StageFunction kStages[] = {
    [](WorldEngine& w) { applyCommands(w.state, *w.pool, w.events, w.rejections); },
    [](WorldEngine& w) { w.orders.run(w.state, *w.pool, w.events); },
    [](WorldEngine& w) { advanceControls(w.state); },
    [](WorldEngine& w) { deformUserMeshes(w.state); },
    [](WorldEngine& w) { deformFinalMeshes(w.state); },
    [](WorldEngine& w) { w.places.run(w.state, *w.pool); },
    [](WorldEngine& w) { w.cost.run(w.state); },
    [](WorldEngine& w) { w.plans.run(w.state, w.cost, w.ways, *w.pool, w.events); },
    [](WorldEngine& w) {
        const double stepTime = w.state.parameters.stepTime;
        w.steering.run(w.state, w.cost, w.ways, stepTime / movesOf(stepTime), *w.pool);
    },
    [](WorldEngine& w) { w.contactReport = w.contacts.run(w.state, w.steering, *w.pool); },
    [](WorldEngine& w) { w.patches.run(w.state); },
    [](WorldEngine& w) { w.happenings.run(w.state, w.patches.events(), w.events); },
};
static_assert(std::size(kStages) == static_cast<std::size_t>(Stage::Count));

// The clock of a browser takes a hundredth of a small world's step: there the stages of every eighth step are
// timed.
#ifdef __EMSCRIPTEN__
constexpr std::uint64_t kTimedEvery = 8;
#else
constexpr std::uint64_t kTimedEvery = 1;
#endif

}  // namespace

void WorldEngine::step() {
    const Stopwatch watch;
    const bool timed = state.stepCount % kTimedEvery == 0;
    double began = 0.0;
    for (std::size_t i = 0; i < std::size(kStages); ++i) {
        kStages[i](*this);
        if (!timed) continue;
        const double ended = watch.milliseconds();
        times.milliseconds[i] = ended - began;
        began = ended;
    }
    ++state.stepCount;
    times.total = watch.milliseconds();
}

}  // namespace muster
