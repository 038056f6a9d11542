// Positions and places of a group's members, side by side as plans read them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/world_state.h"

namespace muster {

/// Owns the arrays of one group at a time.
class MemberArrays {
public:
    /// Gathers the members of a group. Valid until the next call, or until characters move.
    void gather(const Characters& characters, const Group& group);

    std::span<const Vec2> positions() const { return positions_; }  ///< [m]
    std::vector<std::int32_t>& places() { return places_; }         ///< Place of each member; -1 for none.

private:
    std::span<const Vec2> positions_;
    std::vector<Vec2> gathered_;  // Unused by a group that holds all characters.
    std::vector<std::int32_t> places_;
};

}  // namespace muster
