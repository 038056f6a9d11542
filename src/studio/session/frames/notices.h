// What the studio says of how orders get on, in sentences, and the position on the ground that a notice
// refers to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "muster/command.h"
#include "muster/vec2.h"
#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// A sentence about one group.
struct EventNotice {
    protocol::NoticeLevel level = protocol::NoticeLevel::Info;
    std::string code;  ///< Name of the kind of event, or of what was found.
    std::string text;
    Vec2 position;  ///< Where [m].
};

/// Appends what to say of the events of a world's last step: one sentence per group and kind. Arrivals are
/// known by frames alone.
void appendNotices(const World& world, std::vector<EventNotice>& notices);

/// The position at which a finger came down or a new control should be; nothing for other commands.
std::optional<Vec2> positionOf(const CommandBody& command);
/// The same for a message; it uses the first finger that came down.
std::optional<Vec2> positionOf(const protocol::ClientMessage& message);

}  // namespace muster
