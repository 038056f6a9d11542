// What the studio asks of a world beside its public interface: where people would stand, what would come of
// orders after others, and to drop what waits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/formation.h"
#include "muster/order.h"
#include "muster/vec2.h"
#include "muster/world.h"

namespace muster {

/// What keeps characters of a group from a place.
enum class PlaceBar : std::uint8_t {
    None,      ///< They can stand there.
    Obstacle,  ///< It lies in an obstacle that stands still, too near to one, or outside the box.
    CutOff,    ///< No way leads there from where most of the group are.
};

/// What keeps a group from each of these places. Obstacles that move bar nothing. All None for an unknown
/// group.
std::vector<PlaceBar> barsOf(const World& world, GroupId group, std::span<const Vec2> places);

/// The places of a formation for as many characters as a group has, with its centre at a pose. Fails, naming
/// what is wrong, where there is no such group or the formation cannot be made.
Result<std::vector<Vec2>> placesAt(const World& world, GroupId group, const FormationDef& formation,
                                   const Pose& at);

/// As World::forecast, but from a pose to which another order would have brought the formation. Its position
/// is moved into the world's box.
OrderForecast forecastFrom(const World& world, GroupId group, const Order& order, const Pose& from);

/// Drops the commands that wait for the next step or a later one. Returns how many there were.
std::size_t dropWaitingCommands(World& world);

}  // namespace muster
