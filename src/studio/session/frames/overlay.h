// Overlays: the values that the page colours the ground by.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "base/grid.h"
#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Largest number of cells of an overlay; a larger ground uses coarser cells.
inline constexpr std::int32_t kOverlayCells = 1 << 16;

/// Gives an overlay the cells of a part of the ground, coarsened until there are at most kOverlayCells.
Grid putOverlayGrid(protocol::Overlay& overlay, const Grid& ground, const Box& box);
/// The requested values over the ground; nothing for an unknown character, or before the first plan.
std::optional<protocol::Overlay> buildOverlay(const World& world, protocol::OverlayKind kind,
                                              std::uint32_t character);

/// Version of the ground and number of groups that an overlay of reach was made from.
using ReachVersion = std::pair<std::uint64_t, std::uint64_t>;
/// That of a world now.
ReachVersion reachVersion(const World& world);

/// Per cell 0 where characters can get to, 1 where the ground is free but they cannot, and 2 in obstacles;
/// and the gaps that are too narrow for them. Characters start where they stand; without any the largest
/// connected ground counts as reached. Moving obstacles bar nothing.
protocol::Overlay buildReachOverlay(const World& world);

}  // namespace muster
