#include "engine/systems/events/patch_stage.h"

namespace muster {

void PatchStage::run(WorldState& state) {
    events_.clear();
    updateMotions(state.environment, state.parameters.stepTime, state.characters, events_);
}

}  // namespace muster
