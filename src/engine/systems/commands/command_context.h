// The state that a command may read and change while it is applied.
#pragma once

#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "muster/command.h"
#include "muster/event.h"

namespace muster {

/// The world that a command changes, and the command. A function that applies a command and fails changes
/// nothing: it answers NotFound for an id that the world lacks, else InvalidArgument or LimitExceeded.
struct CommandContext {
    WorldState& state;
    ThreadPool& pool;
    std::vector<Event>& events;  ///< The events of this step.
    const Command& command;      ///< The command, with its sender.

    /// The state, for a command that changes groups: waits for background work, which reads their plans.
    WorldState& groups() {
        pool.wait();
        return state;
    }
    /// The ground, for a command that changes it: waits for background work, which reads the ground.
    Environment& ground() {
        pool.wait();
        return state.environment;
    }
};

}  // namespace muster
