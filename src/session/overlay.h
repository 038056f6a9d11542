// What the ground can be coloured by.
#pragma once

#include <optional>

#include "muster/world.h"
#include "session/protocol.h"

namespace muster {

/// Largest number of cells of an overlay; a larger ground is shown in coarser cells.
inline constexpr std::int32_t kOverlayCells = 1 << 16;

/// Values of the kind asked for, over the ground; None where there are none (an unknown character, no plan
/// yet).
std::optional<protocol::Overlay> buildOverlay(const World& world, protocol::OverlayKind kind,
                                              std::uint32_t character);

}  // namespace muster
