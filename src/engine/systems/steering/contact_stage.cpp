#include "engine/systems/steering/contact_stage.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Pushed by contacts, nobody moves faster than this many times its top speed.
constexpr double kContactShare = 1.04;

/// True on ground where a motion of a single step begins, such as a climb.
bool isSingleStep(const Environment& environment, Vec2 p) {
    const GroundSample ground = environment.ground(p);
    return ground.patch.value != 0 && !environment.def().clips[ground.motion].cyclic;
}

}  // namespace

// Nobody is pushed over the edge of ground where it would have to climb or jump, in or out.
void ContactStage::holdAtEdges(const Environment& environment, std::span<Vec2> positions) const {
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (!(positions[i] == steered_[i]) &&
            isSingleStep(environment, positions[i]) != isSingleStep(environment, steered_[i]))
            positions[i] = steered_[i];
}

std::int32_t movesOf(double stepTime) {
    constexpr double kMostMoves = 30.0;  // Of one part of a step, per second.
    return static_cast<std::int32_t>(std::max(1.0, std::ceil(stepTime * kMostMoves - 1e-9)));
}

ContactReport ContactStage::run(WorldState& state, SteeringStage& steering, double dt, ThreadPool& pool) {
    Characters& characters = state.characters;
    NextMotion& next = steering.next();
    const CrowdBodies& bodies = steering.bodies();
    reach_.assign(steering.topSpeeds().begin(), steering.topSpeeds().end());
    for (double& reach : reach_) reach *= kContactShare * dt;
    const bool edges = !state.environment.patchIds().empty();
    if (edges) steered_.assign(next.position.begin(), next.position.end());
    const ContactReport report = contacts_.resolve(
        state.parameters.contact, state.parameters.character, state.environment, next.position,
        &steering.neighbours(), &pool, {characters.position, reach_}, &bodies, &steering.axes());
    if (edges) holdAtEdges(state.environment, next.position);
    // Speed that contacts took away is lost; what they pushed adds none.
    for (std::size_t i = 0; i < characters.size(); ++i) {
        characters.heading[i] = next.heading[i];
        if (bodies.isFixed(i)) continue;
        const Vec2 moved = (next.position[i] - characters.position[i]) / dt;
        characters.velocity[i] = clampLength(moved, length(next.velocity[i]));
        characters.position[i] = next.position[i];
    }
    return report;
}

}  // namespace muster
