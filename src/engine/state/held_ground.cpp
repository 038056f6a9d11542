#include "engine/state/held_ground.h"

#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

constexpr std::size_t kMostHeld = 64;  // Spots that are looked at.
constexpr double kStands = 0.05;       // Who is slower stands [m/s].

}  // namespace

void listHeld(const WorldState& state, const Group& group, std::vector<HeldSpot>& held) {
    held.clear();
    const Characters& c = state.characters;
    for (const Group& other : state.groups) {
        if (other.id == group.id || other.def.conduct.stance != Stance::Hold) continue;
        for (const std::int32_t i : other.members)
            if (held.size() < kMostHeld && lengthSquared(c.velocity[i]) < kStands * kStands)
                held.push_back({c.position[i], radiusOf(state.parameters.character, c.body[i])});
    }
}

}  // namespace muster
