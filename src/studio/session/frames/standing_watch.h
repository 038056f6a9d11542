// Watches who cannot be in place, and tells of it once people have come to rest.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "engine/world/standings.h"
#include "studio/session/frames/notices.h"

namespace muster {

/// What a session tells of people who stand elsewhere than in their places, and of those in obstacles.
class StandingWatch {
public:
    /// Begins with a new world.
    void restart() { *this = {}; }
    /// Appends what to say after a step.
    void observe(const World& world, std::vector<EventNotice>& notices);

private:
    /// What is known of a group.
    struct Known {
        StandingCounts counts{};      ///< At the last look.
        std::int32_t rests = 0;       ///< Looks for which nobody was on the way and nothing changed.
        std::uint32_t announced = 0;  ///< How many were said to be out of place; 0 for nobody.
        std::uint32_t without = 0;    ///< How many places no way leads to, as an event says.
    };

    void heed(const World& world);
    void look(const World& world, std::vector<EventNotice>& notices);
    void findBuried(const World& world, std::vector<EventNotice>& notices);

    std::map<std::uint32_t, Known> groups_;  // By id.
    std::optional<std::uint64_t> ground_;    // Static version of the ground; none before the first step.
};

}  // namespace muster
