// The world that both peers make from nothing but this code.
#pragma once

#include <muster/world.h>

#include <cstdint>
#include <vector>

namespace lockstep {

/// Two groups of so many people, one for each player, a few houses and a cart that drives round. The class of
/// a body tells its player: 1 for player 0, 2 for player 1.
muster::Result<muster::World> makeBattlefield(std::int32_t people);

/// Indices of a player's groups that have people.
std::vector<std::size_t> groupsOf(const muster::World& world, std::uint32_t player);

}  // namespace lockstep
