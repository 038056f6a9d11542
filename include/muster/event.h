// What happened in a step.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// Kinds of events.
enum class EventKind : std::uint8_t {
    EnterPatch,       ///< `value` is the patch.
    LeavePatch,       ///< `value` is the patch.
    TransitionStart,  ///< Into or out of a motion; `value` is the motion id.
    TransitionEnd,    ///< `value` is the motion id.
    SingleStep,       ///< A jump or climb begins; `value` is the motion id.
    Collect,          ///< `value` is the index of the item.
    FormationChange,  ///< `subject` is the group.
    Swap,             ///< A character's place changed without a command; `value` is the new place.
};

/// One event.
struct Event {
    EventKind kind = EventKind::EnterPatch;
    std::uint32_t subject = 0;  ///< Character id (or group id).
    std::uint32_t value = 0;    ///< See the kind.
    Vec2 position;              ///< Where [m].

    /// Lets an archive read or write the event.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, subject, value, position);
    }
};

}  // namespace muster
