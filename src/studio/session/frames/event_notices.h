// What the studio says of how orders get on, in sentences.
#pragma once

#include <string>
#include <vector>

#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// A sentence about one group.
struct EventNotice {
    protocol::NoticeLevel level = protocol::NoticeLevel::Info;
    std::string code;  ///< Name of the kind of event.
    std::string text;
    Vec2 position;  ///< Where [m].
};

/// Appends what to say of the events of a world's last step: one sentence per group and kind.
void appendNotices(const World& world, std::vector<EventNotice>& notices);

}  // namespace muster
