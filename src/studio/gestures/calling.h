// Who comes where somebody is called to (docs/method/gestures.md).
#pragma once

#include <cstdint>
#include <optional>

#include "muster/world.h"

namespace muster {

/// Id of the character that is nearest to a point [m]; a way that an obstacle bars counts twice. Who is alone
/// and still on the way to an order does not turn round. None where nobody is left. Of two that are as near
/// the one with the smaller id comes.
std::optional<std::uint32_t> whoComes(const World& world, Vec2 to);

}  // namespace muster
