// What exported trajectories tell of a character beside its position.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "files/export/exporter.h"

namespace muster {

/// Facts of one character in one frame.
struct PersonFacts {
    std::uint32_t group = 0;     ///< Id of its group; 0 where the character has just left.
    int motion = -1;             ///< Index into the world's clips; -1 where it has just left.
    std::uint32_t goal = 0;      ///< Id of the exit or waiting area that it goes to; 0 for none.
    std::string_view groupName;  ///< Of its group, while the world stands.
    double speed = 0.0;          ///< [m/s]
};

/// Finds the facts of the characters of a frame, asked for in ascending order of ids.
class PersonFactsReader {
public:
    explicit PersonFactsReader(const ExportFrame& frame) : world_(*frame.world), shown_(frame.shown) {}

    PersonFacts of(std::uint32_t id) {
        const CharactersView all = world_.characters();
        while (at_ < all.size() && all.id[at_] < id) ++at_;
        if (at_ == all.size() || all.id[at_] != id) return {};
        const GroupView group = world_.group(all.group[at_]);
        PersonFacts facts{group.id.value, all.motion[at_], at_ < all.goal.size() ? all.goal[at_] : 0,
                          group.name, length(all.velocity[at_])};
        while (next_ < shown_.size() && shown_[next_].id < id) ++next_;
        if (next_ == shown_.size() || shown_[next_].id != id || !shown_[next_].moved) return facts;
        facts.motion = shown_[next_].motion;
        facts.speed = length(shown_[next_].velocity);
        return facts;
    }

private:
    const World& world_;
    std::span<const ShownCharacter> shown_;
    std::size_t at_ = 0, next_ = 0;
};

}  // namespace muster
