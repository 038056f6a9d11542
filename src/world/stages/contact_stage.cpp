#include "world/stages/contact_stage.h"

#include "world/state/layer_defs.h"

namespace muster {
namespace {

// Pushed by contacts, nobody moves faster than this many times its top speed.
constexpr double kContactShare = 1.04;

}  // namespace

ContactReport ContactStage::run(WorldState& state, SteeringStage& steering, ThreadPool& pool) {
    Characters& characters = state.characters;
    NextMotion& next = steering.next();
    reach_.assign(steering.topSpeeds().begin(), steering.topSpeeds().end());
    for (double& reach : reach_) reach *= kContactShare * state.parameters.stepTime;
    const ContactReport report = contacts_.resolve(contactDef(state.parameters), state.environment,
                                                   next.position, &steering.neighbours(), &pool,
                                                   {characters.position, reach_});
    // Speed that contacts took away is lost; what they pushed adds none.
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Vec2 moved = (next.position[i] - characters.position[i]) / state.parameters.stepTime;
        characters.velocity[i] = clampLength(moved, length(next.velocity[i]));
        characters.position[i] = next.position[i];
        characters.heading[i] = next.heading[i];
    }
    return report;
}

}  // namespace muster
