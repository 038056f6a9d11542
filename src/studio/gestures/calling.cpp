#include "studio/gestures/group_lookup.h"

#include <limits>

#include "engine/geometry/polygon.h"

namespace muster {
namespace {

constexpr double kBarred = 2.0;  // So many times as far counts who has to go round an obstacle.

bool barred(const World& world, Vec2 from, Vec2 to) {
    for (const ObstacleId id : world.obstacleIds()) {
        const ObstacleView obstacle = world.obstacle(id);
        const double gap = obstacle.def.radius > 0.0
                               ? segmentDistance(obstacle.centre, obstacle.centre, from, to) -
                                     obstacle.def.radius
                               : segmentDistance(obstacle.outline, from, to);
        if (gap <= 0.0) return true;
    }
    return false;
}

// Who has been called elsewhere and is still on the way there.
bool called(const World& world, std::size_t group) {
    return world.group(group).members.size() == 1 && !world.group(group).orders.empty();
}

}  // namespace

std::optional<std::uint32_t> whoComes(const World& world, Vec2 to) {
    const CharactersView characters = world.characters();
    std::optional<std::uint32_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < characters.size(); ++i) {
        double away = distance(characters.position[i], to);
        if (away > least || called(world, static_cast<std::size_t>(characters.group[i]))) continue;
        if (barred(world, characters.position[i], to)) away *= kBarred;
        if (away > least || (away == least && best && *best < characters.id[i])) continue;
        least = away;
        best = characters.id[i];
    }
    return best;
}

}  // namespace muster
