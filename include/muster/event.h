// Events: what happened in a step.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// Kinds of events. Those from Arrived on tell how orders get on and how groups change; each from Arrived to
/// Partial comes once per order and version of the ground. An order is a pose, a formation, a count or a
/// drawn way; the ground changes with every command that changes obstacles or patches.
enum class EventKind : std::uint8_t {
    EnterPatch,       ///< `value` is the id of the patch.
    LeavePatch,       ///< `value` is the id of the patch.
    TransitionStart,  ///< A transition into or out of a motion begins; `value` is the motion id.
    TransitionEnd,    ///< A transition has ended; `value` is the motion id.
    SingleStep,       ///< A jump or climb begins; `value` is the motion id.
    Collect,          ///< An item was collected; `value` is the index of the item.
    FormationChange,  ///< A group has another formation; `subject` is the id of the group.
    Swap,             ///< A character's place changed without a command; `value` is the new place.
    /// All of a group's characters that have a place are within 0.5 m of it for 1 s, and the places stand
    /// where the order wants them; `value` is their number.
    Arrived,
    /// A character is not at its place and has moved less than 0.25 m over the last 5 s, and not in a queue
    /// that moves on; `value` is the place. Raised again only once it has moved.
    Stuck,
    /// The ground cut off the way of `value` characters of a group, or for 2 s a moving obstacle did, as a
    /// gate that closes. One that only passes gives no event.
    Blocked,
    Free,  ///< All of a group have their way again; `value` is how many had none.
    /// No place of the group's order can be reached, or not by its largest members, who stay behind; `value`
    /// is the number of those concerned.
    NoPath,
    Partial,       ///< `value` places of the group's order cannot be reached; the others can.
    OrderGiven,    ///< A group was given the order of id `value`.
    OrderBegun,    ///< It begins the order of id `value`.
    OrderDone,     ///< It has carried out the order of id `value`.
    OrderSkipped,  ///< It passes over the order of id `value`, whose target cannot be reached.
    Passed,        ///< A group has passed the checkpoint of index `value`.
    GroupAdded,    ///< A group is new; `value` is the id of the group that it was split off, 0 for none.
    GroupRemoved,  ///< A group has ended; `value` is the id of the group that it was merged into, 0 for none.
    Joined,        ///< A character is new; `value` is the id of its group.
    Left,          ///< A character has left the world; `value` is the id of its group.
    Transferred,   ///< A character has changed groups; `value` is the id of its new group.
    Exited,        ///< A character has left the world by an exit; `value` is the id of that area.
    Entered,       ///< A character has come into the world by a source; `value` is the id of that area.
    Count
};
/// The name of a kind: "enterPatch", "arrived"...
const char* eventKindName(EventKind kind);
/// True for the kinds that tell how an order gets on.
constexpr bool isOrderEvent(EventKind kind) {
    return kind >= EventKind::Arrived && kind < EventKind::Count;
}

/// One event.
struct Event {
    EventKind kind = EventKind::EnterPatch;  ///< What happened.
    std::uint32_t subject = 0;  ///< Id of the character; of the group where the kind speaks of one.
    std::uint32_t value = 0;    ///< Its meaning depends on the kind.
    Vec2 position;              ///< Where it happened [m]: the middle of those concerned.

    /// Lets an archive read or write the event.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, subject, value, position);
    }
    /// Equal in all parts.
    friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace muster
