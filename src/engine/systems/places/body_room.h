// Places make room for large bodies that hold some of them.
#pragma once

#include <vector>

#include "engine/formation/places/room_for_bodies.h"
#include "engine/state/world_state.h"

namespace muster {

/// Moves the targets of a group whose members differ in size. Its working memory is reused.
class BodyRoom {
public:
    /// Moves `targets` [m], those of the mesh of `group`, as far as the holders of the places need it.
    /// Changes nothing where all members have one size.
    void run(const WorldState& state, Group& group, std::vector<Vec2>& targets);

private:
    bool gatherRadii(const WorldState& state, const Group& group);
    void find(Group& group, std::uint64_t key);

    RoomForBodies room_;
    std::vector<double> radii_;  // Radius of the holder of each place [m].
    std::vector<Vec2> rest_;     // Places on the rest shape [m].
    double mean_ = 0.0;          // Mean radius of members [m].
};

}  // namespace muster
