// A route that a character follows on its own, because the guidance of its plan did not get it to its place.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// The route of one character, by the exact ground.
struct OwnRoute {
    std::uint32_t character = 0;  ///< Its id.
    std::int32_t place = -1;      ///< Where it leads.
    std::uint32_t since = 0;      ///< Step in which the character began to follow routes.
    Vec2 goal;                    ///< Position of the place when the route was searched [m].
    float cost = 0.0f;            ///< Length of what is left of it, in metres of open ground.
    std::vector<Vec2> path;       ///< Corners still ahead, the goal last [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(character, place, since, goal, cost, path);
    }
};

/// The route of a character; null where it has none. `routes` ascend by character.
inline const OwnRoute* ownRouteOf(const std::vector<OwnRoute>& routes, std::uint32_t character) {
    const auto at = std::lower_bound(
        routes.begin(), routes.end(), character,
        [](const OwnRoute& route, std::uint32_t id) { return route.character < id; });
    return at != routes.end() && at->character == character ? &*at : nullptr;
}

}  // namespace muster
