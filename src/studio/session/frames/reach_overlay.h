// The overlay of what can be reached: for whoever makes a place.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Version of the ground and number of groups that an overlay of reach was made from.
using ReachVersion = std::pair<std::uint64_t, std::uint64_t>;
/// That of a world now.
ReachVersion reachVersion(const World& world);

/// Per cell 0 where characters can get to, 1 where the ground is free but they cannot, and 2 in obstacles;
/// and the gaps that are too narrow for them. Characters start where they stand; without any the largest
/// connected ground counts as reached. Moving obstacles bar nothing.
protocol::Overlay buildReachOverlay(const World& world);

}  // namespace muster
