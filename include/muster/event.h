// Events: what happened in a step.
#pragma once

#include <cstdint>

#include "muster/generated/enumerations.h"
#include "muster/vec2.h"

namespace muster {

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
