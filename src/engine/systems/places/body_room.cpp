#include "engine/systems/places/body_room.h"

#include <algorithm>

#include "base/hash.h"
#include "engine/formation/mesh/rigid_fit.h"
#include "engine/state/ground_class.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

constexpr double kRoomSpeed = 1.0;        // Speed at which places make room [m/s].
constexpr std::uint32_t kRoomSteps = 15;  // Steps between two looks at the holders of places.

}  // namespace

// Gathers the radii of the holders of places; false where all members have one size. A place without a holder
// has the mean radius.
bool BodyRoom::gatherRadii(const WorldState& state, const Group& group) {
    const auto radius = [&](std::int32_t i) {
        return radiusOf(state.parameters.character, state.characters.body[i]);
    };
    const auto& members = group.members;
    if (std::all_of(members.begin(), members.end(),
                    [&](std::int32_t i) { return radius(i) == radius(members[0]); }))
        return false;
    mean_ = meanRadius(state, group);
    radii_.assign(group.places.positions().size(), mean_);
    for (const std::int32_t i : members)
        if (const std::int32_t place = state.characters.place[i]; place >= 0) radii_[place] = radius(i);
    return true;
}

void BodyRoom::find(Group& group, std::uint64_t key) {
    PlaceRoom& room = group.room;
    const bool isNew = room.given.size() != radii_.size();
    room.key = key;
    room.wanted = rest_;
    room_.make(radii_, 2.0 * mean_, room.wanted);
    for (std::size_t k = 0; k < rest_.size(); ++k) room.wanted[k] -= rest_[k];
    if (isNew) room.given = room.wanted;
}

void BodyRoom::run(const WorldState& state, Group& group, std::vector<Vec2>& targets) {
    PlaceRoom& room = group.room;
    if (!gatherRadii(state, group) || radii_.size() != targets.size()) {
        room = {};
        return;
    }
    group.mesh.restPlaces(rest_);
    const bool isNew = room.given.size() != radii_.size();
    if (isNew || state.stepCount % kRoomSteps == 0) {
        Hash hasher;
        hasher.add(group.formationVersion);
        for (const double radius : radii_) hasher.add(radius);
        if (isNew || hasher.value() != room.key) find(group, hasher.value());
    }
    const double most = kRoomSpeed * state.parameters.stepTime;
    const Rotation turn = bestRigidFit(rest_, targets).rotation;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        const Vec2 missing = room.wanted[k] - room.given[k];
        const double far = length(missing);
        room.given[k] = far <= most ? room.wanted[k] : room.given[k] + missing * (most / far);
        targets[k] += turn.apply(room.given[k]);
    }
}

}  // namespace muster
