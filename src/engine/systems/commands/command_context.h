// What a command may read and change while it is applied.
#pragma once

#include <vector>

#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "muster/command.h"
#include "muster/event.h"

namespace muster {

/// The world that a command changes, and the command. A function that applies a command changes nothing where
/// it fails: with NotFound where the world lacks what is named, else with InvalidArgument or LimitExceeded.
struct CommandContext {
    WorldState& state;
    ThreadPool& pool;
    std::vector<Event>& events;  ///< Of this step.
    const Command& command;      ///< With its sender.

    /// The state, for a change of groups: work in the background reads their plans.
    WorldState& groups() {
        pool.wait();
        return state;
    }
    /// The ground, for a change of it: work in the background reads it.
    Environment& ground() {
        pool.wait();
        return state.environment;
    }
};

}  // namespace muster
