#include "engine/systems/goals/waiting_spots.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polygon.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kSpotsApart = 1.2;   // Least distance of spots, in diameters.
constexpr double kSpotsAtMost = 3.0;  // Greatest distance, in diameters.
constexpr double kSpotsFill = 0.75;   // Share of the area that those who come fill with their squares.
constexpr double kComesIn = 1.0;      // Who is so near the area gets a spot [m].
constexpr double
    kNoRoomAfter = 1.5;  // Who has not got on for so long stands before an area that is full [s].

double largestMember(const WorldState& state, const Group& group) {
    const Parameters::Character& usual = state.parameters.character;
    double largest = usual.radius;
    for (const std::int32_t i : group.members)
        largest = std::max(largest, radiusOf(usual, state.characters.body[i]));
    return largest;
}

}  // namespace

// Spots on a square grid: as far apart as all the group's members leave them.
void WaitingSpots::listFree(const WorldState& state, const Group& group, const Area& area) {
    const Polygon& polygon = area.def.polygon;
    const double radius = largestMember(state, group), diameter = 2.0 * radius;
    const double people = std::max<double>(1.0, static_cast<double>(group.members.size()));
    const double wide = std::sqrt(kSpotsFill * std::fabs(signedArea(polygon)) / people);
    const double apart = std::clamp(wide, kSpotsApart * diameter, kSpotsAtMost * diameter);
    taken_.clear();
    for (const Gathering& other : state.continuum.gatherings)
        for (const StandingSpot& spot : other.spots) taken_.push_back(spot.spot);
    free_.clear();
    const Box box = boundsOf(polygon);
    const auto columns = static_cast<std::int32_t>(box.width() / apart);
    const auto rows = static_cast<std::int32_t>(box.height() / apart);
    const Vec2 margin{0.5 * (box.width() - columns * apart), 0.5 * (box.height() - rows * apart)};
    for (std::int32_t y = 0; y <= rows; ++y)
        for (std::int32_t x = 0; x <= columns; ++x) {
            const Vec2 p = box.min + margin + Vec2{x * apart, y * apart};
            const auto isNear = [&](Vec2 q) {
                return distance(p, q) < kSpotsApart * diameter * (1.0 - 1e-9);
            };
            if (!containsPoint(polygon, p) || state.environment.distanceToObstacle(p, radius) < radius)
                continue;
            if (!state.environment.def().box.grown(-radius).contains(p)) continue;
            if (std::none_of(taken_.begin(), taken_.end(), isNear)) free_.push_back(p);
        }
}

// Gives free spots to those who have come; false where one of them found none.
bool WaitingSpots::takeSpots(const WorldState& state, const Group& group, Gathering& gathering,
                             const Area& area, const StaticGround& ground) {
    const Characters& c = state.characters;
    const Polygon& polygon = area.def.polygon;
    const double apart = kSpotsApart * 2.0 * largestMember(state, group) * (1.0 - 1e-9);
    bool listed = false;
    for (const std::int32_t i : group.members) {
        if (gathering.spotOf(c.id[i]) != nullptr) continue;
        const Vec2 p = c.position[i];
        const Vec2 near = closestOnBoundary(polygon, p).point;
        const bool in = containsPoint(polygon, p) ||
                        (distance(near, p) < kComesIn && ground.collisionFree(p, near));
        if (!in) continue;
        if (!listed) listFree(state, group, area);
        listed = true;
        // Who comes first goes farthest in, so that nobody stands in the way of others.
        const auto better = [&](Vec2 a, Vec2 b) { return lengthSquared(a - p) > lengthSquared(b - p); };
        auto best = free_.end();
        for (auto at = free_.begin(); at != free_.end(); ++at)
            if ((best == free_.end() || better(*at, *best)) && ground.collisionFree(p, *at)) best = at;
        if (best == free_.end()) return false;
        const Vec2 taken = *best;
        gathering.stand(c.id[i], taken);
        std::erase_if(free_, [&](Vec2 q) { return distance(q, taken) < apart; });
    }
    return true;
}

void WaitingSpots::run(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
                       const StaticGround& ground) {
    const Characters& c = state.characters;
    std::erase_if(gathering.spots, [&](const StandingSpot& spot) {
        const std::int32_t i = c.indexOf(spot.character);
        return i < 0 || &state.groups[c.group[i]] != &group;
    });
    if (gathering.spots.size() == group.members.size()) return;
    if (takeSpots(state, group, gathering, area, ground)) {
        gathering.arrived.clear();
        return;
    }
    const std::uint32_t patience = stepsIn(state, kNoRoomAfter);
    for (const std::int32_t i : group.members) {
        if (gathering.spotOf(c.id[i]) != nullptr || gathering.hasArrived(c.id[i])) continue;
        const double away = signedDistance(area.def.polygon, c.position[i]);
        if (away > kComesIn && state.stepCount - c.walk[i].movedAt < patience) continue;
        gathering.arrived.insert(
            std::lower_bound(gathering.arrived.begin(), gathering.arrived.end(), c.id[i]), c.id[i]);
    }
}

}  // namespace muster
