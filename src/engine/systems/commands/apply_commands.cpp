#include "engine/systems/commands/apply_commands.h"

#include "engine/state/ground_class.h"
#include "engine/systems/commands/body_commands.h"
#include "engine/systems/commands/ended_paths.h"
#include "engine/systems/commands/generated/command_functions.h"

namespace muster {
namespace {

// Lists the areas of the ground that were edited since `version`. More than kMostEdits edits count as one
// edit of the whole ground, since the environment remembers only the latest of them.
void listEdits(WorldState& state, std::uint64_t version) {
    constexpr std::uint32_t kMostEdits = 64;
    const Grid& grid = state.environment.grid();
    state.editedAreas.clear();
    state.editedPatches = state.environment.staticPatchVersion() > version;
    if (state.groundEdits - state.editsBefore <= kMostEdits &&
        state.environment.staticChangesSince(version, state.editedAreas))
        return;
    state.editedAreas.assign(1, {{0, 0}, {grid.width - 1, grid.height - 1}});
}

}  // namespace

void applyCommands(WorldState& state, ThreadPool& pool, std::vector<Event>& events,
                   std::vector<Rejection>& rejections) {
    events.clear();
    rejections.clear();
    restOutside(state);
    const std::uint64_t version = state.environment.staticVersion();
    state.editsBefore = state.groundEdits;
    std::vector<Command>& queue = state.queue;
    std::ptrdiff_t done = 0;
    while (done < std::ssize(queue) && queue[done].step <= state.stepCount) {
        const Command& command = queue[done++];
        CommandContext context{state, pool, events, command};
        const Status status = std::visit([&](const auto& body) { return apply(context, body); },
                                         command.body);
        if (status.ok())
            state.lastCommandStep = state.stepCount;
        else
            rejections.push_back({command, status});
    }
    queue.erase(queue.begin(), queue.begin() + done);
    state.environment.setTime(state.time());
    settleEndedPaths(state, pool);
    listEdits(state, version);
    updateGroundClasses(state, pool);
}

}  // namespace muster
