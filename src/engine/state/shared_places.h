// Places that several characters share, since these demand more than each supplies (SPEC A1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/world_state.h"

namespace muster {

/// True where places of the group demand, or members supply, more or less than one each.
bool hasWeights(const WorldState& state, const Group& group);

/// How much room those need who share a place. They stand around it, and are as good as there.
class SharedPlaces {
public:
    /// Looks at all groups that have weights.
    void find(const WorldState& state);
    /// Looks at one group only; for members of others there is no room.
    void find(const WorldState& state, const Group& group);

    /// By how much farther than others a character may stand from its place [m] >= 0.
    double room(std::size_t character) const { return room_.empty() ? 0.0 : room_[character]; }
    /// The same of all characters; empty where no group has weights.
    std::span<const double> rooms() const { return room_; }

private:
    void add(const WorldState& state, const Group& group);

    std::vector<double> room_;         // Per character [m].
    std::vector<std::int32_t> count_;  // Characters of each place of a group.
};

}  // namespace muster
