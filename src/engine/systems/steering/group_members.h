// Positions and places of the members of groups, side by side as plans and their guidance read them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/world_state.h"

namespace muster {

/// The members of one group.
class MemberArrays {
public:
    /// Gathers the members of a group. Positions are valid until characters move.
    void gather(const Characters& characters, const Group& group);
    /// Takes over the places by a new plan.
    void setPlaces(std::span<const std::int32_t> places) { places_.assign(places.begin(), places.end()); }

    std::span<const Vec2> positions() const { return positions_; }    ///< [m]
    std::span<const std::int32_t> places() const { return places_; }  ///< Place of each member; -1 for none.

private:
    std::span<const Vec2> positions_;
    std::vector<Vec2> gathered_;  // Positions of the members; unused by a group that holds all characters.
    std::vector<std::int32_t> places_;
};

/// The members of all groups. They are gathered once in each step, for plans and guidance.
class GroupMembers {
public:
    /// Gathers the members of all groups.
    void gather(const WorldState& state);
    /// The arrays of the group of that index.
    MemberArrays& of(std::size_t group) { return groups_[group]; }
    /// The arrays of the group of that index.
    const MemberArrays& of(std::size_t group) const { return groups_[group]; }

private:
    std::vector<MemberArrays> groups_;
};

}  // namespace muster
