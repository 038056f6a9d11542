// Requests of the studio to a world beside its public interface: positions of a formation's places, forecasts
// of orders after others, and a way to drop waiting commands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/order.h"
#include "muster/vec2.h"
#include "muster/world.h"

namespace muster {

/// Whether a group can stand at each of these places: InPlace, or what keeps it from there. Moving obstacles
/// bar nothing. All InPlace for an unknown group.
std::vector<Standing> barsOf(const World& world, GroupId group, std::span<const Vec2> places);

/// The places of a formation for `count` > 0 characters with its centre at a pose. Fails, naming the cause,
/// where the formation cannot be made.
Result<std::vector<Vec2>> placesAt(const FormationDef& formation, int count, const Pose& at);

/// The places of a formation for `count` characters (0: as many as a group has), with its centre at a pose.
/// Fails, naming the cause, where there is no such group or the formation cannot be made.
Result<std::vector<Vec2>> placesAt(const World& world, GroupId group, const FormationDef& formation,
                                   const Pose& at, int count);

/// The forecast of an order like World::forecast, but from a pose to which another order would have brought
/// the formation. Its position is moved into the world's box.
OrderForecast forecastFrom(const World& world, GroupId group, const Order& order, const Pose& from);

/// Drops the commands that wait for the next step or a later one. Returns their number.
std::size_t dropWaitingCommands(World& world);

}  // namespace muster
