// The position on the ground that a notice refers to.
#pragma once

#include <optional>

#include "muster/command.h"
#include "muster/vec2.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The position at which a finger came down or a new control should be; nothing for other commands.
std::optional<Vec2> positionOf(const CommandBody& command);
/// The same for a message; it uses the first finger that came down.
std::optional<Vec2> positionOf(const protocol::ClientMessage& message);

}  // namespace muster
