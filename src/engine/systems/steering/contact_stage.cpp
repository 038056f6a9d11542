#include "engine/systems/steering/contact_stage.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Factor of its top speed up to which contacts may push a character.
constexpr double kContactSpeedFactor = 1.04;

// Moves a character that has walked out on one side of a ring in on the other, with its progress and claim.
void walkRound(Characters& characters, const Ring& ring) {
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Vec2 shift{ring.shiftOf(characters.position[i].x), 0.0};
        if (shift == Vec2{}) continue;
        characters.position[i] += shift;
        characters.walk[i].anchor += shift;
        characters.walk[i].camp += shift;
        characters.claim[i].spot += shift;
    }
}

}  // namespace

std::int32_t movesOf(double stepTime) {
    constexpr double kMovesPerSecond = 30.0;  // Least number of moves in a second [1/s].
    return static_cast<std::int32_t>(std::max(1.0, std::ceil(stepTime * kMovesPerSecond - 1e-9)));
}

ContactReport ContactStage::run(WorldState& state, SteeringStage& steering, double dt, ThreadPool& pool) {
    Characters& characters = state.characters;
    NextMotion& next = steering.next();
    const CrowdBodies& bodies = steering.bodies();
    reach_.assign(steering.topSpeeds().begin(), steering.topSpeeds().end());
    for (double& reach : reach_) reach *= kContactSpeedFactor * dt;
    const ContactReport report = contacts_.resolve(
        state.parameters.contact, state.parameters.character, state.environment, next.position,
        &steering.neighbours(), &pool, {characters.position, reach_}, &bodies, &steering.axes());
    // Contacts can take speed away, but add none.
    for (std::size_t i = 0; i < characters.size(); ++i) {
        characters.heading[i] = next.heading[i];
        if (bodies.isFixed(i)) continue;
        const Vec2 moved = (next.position[i] - characters.position[i]) / dt;
        characters.velocity[i] = clampLength(moved, length(next.velocity[i]));
        characters.position[i] = next.position[i];
    }
    if (state.environment.def().ring) walkRound(characters, state.environment.def().joined());
    return report;
}

}  // namespace muster
