// The stage of patches: the motion of each character (SPEC C1, C3, C4).
#pragma once

#include <span>
#include <vector>

#include "engine/state/world_state.h"
#include "engine/steering/motion_state.h"

namespace muster {

/// Follows characters into and out of patches.
class PatchStage {
public:
    /// Writes motions, phases and patches of characters.
    void run(WorldState& state);

    std::span<const MotionEvent> events() const { return events_; }  ///< Changes of the last run.

private:
    std::vector<MotionEvent> events_;
};

}  // namespace muster
