#include "engine/systems/steering/group_members.h"

namespace muster {

void MemberArrays::gather(const Characters& characters, const Group& group) {
    const std::size_t count = group.members.size();
    if (count == characters.size()) {
        places_.assign(characters.place.begin(), characters.place.end());
        positions_ = characters.position;
        return;
    }
    gathered_.resize(count);
    places_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t i = group.members[k];
        gathered_[k] = characters.position[i];
        places_[k] = characters.place[i];
    }
    positions_ = gathered_;
}

void GroupMembers::gather(const WorldState& state) {
    groups_.resize(state.groups.size());
    for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g].gather(state.characters, state.groups[g]);
}

}  // namespace muster
