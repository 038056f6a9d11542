#include "engine/state/held_ground.h"

#include <utility>

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
        if (other.id == group.id || !holdsGround(other)) continue;
        const std::vector<Vec2>& places = other.places.reachableTargets();
        for (const std::int32_t i : other.members) {
            const bool stands = lengthSquared(c.velocity[i]) < kStands * kStands;
            const bool comes = c.place[i] >= 0 && std::cmp_less(c.place[i], places.size());
            if (held.size() >= kMostHeld || !(stands || comes)) continue;
            const double radius = radiusOf(state.parameters.character, c.body[i]);
            held.push_back({stands ? c.position[i] : places[c.place[i]], radius + kHeldMargin});
        }
    }
}

}  // namespace muster
