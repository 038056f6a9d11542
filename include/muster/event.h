// Events: what happened in a step.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// Kinds of events.
enum class EventKind : std::uint8_t {
    EnterPatch,       ///< `value` is the id of the patch.
    LeavePatch,       ///< `value` is the id of the patch.
    TransitionStart,  ///< A transition into or out of a motion begins; `value` is the motion id.
    TransitionEnd,    ///< A transition has ended; `value` is the motion id.
    SingleStep,       ///< A jump or climb begins; `value` is the motion id.
    Collect,          ///< An item was collected; `value` is the index of the item.
    FormationChange,  ///< A group has another formation; `subject` is the id of the group.
    Swap,             ///< A character's place changed without a command; `value` is the new place.
};

/// One event.
struct Event {
    EventKind kind = EventKind::EnterPatch;  ///< What happened.
    std::uint32_t subject = 0;               ///< Id of the character, or of the group for FormationChange.
    std::uint32_t value = 0;                 ///< Its meaning depends on the kind.
    Vec2 position;                           ///< Where it happened [m].

    /// Lets an archive read or write the event.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, subject, value, position);
    }
};

}  // namespace muster
