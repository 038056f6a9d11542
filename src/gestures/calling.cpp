#include "gestures/calling.h"

#include <limits>

namespace muster {
namespace {

constexpr double kBarred = 2.0;  // So many times as far counts who has to go round an obstacle.

bool crosses(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p) > 0.0; };
    return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

bool barred(const World& world, Vec2 from, Vec2 to) {
    for (const ObstacleId id : world.obstacleIds()) {
        const auto& outline = world.obstacle(id).outline;
        for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
            if (crosses(from, to, outline[j], outline[i])) return true;
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
