// Overlays: the values that the page colours the ground by.
#pragma once

#include <optional>

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

}  // namespace muster
