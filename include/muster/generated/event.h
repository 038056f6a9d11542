// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// What happened in a step.
#pragma once

#include <cstdint>

#include "muster/generated/enumerations.h"
#include "muster/vec2.h"

namespace muster {

/// One event.
struct Event {
    EventKind kind = EventKind::EnterPatch;  ///< What happened.
    /// Id of the character; of the group where the kind speaks of one.
    std::uint32_t subject = 0;
    std::uint32_t value = 0;  ///< Its meaning depends on the kind.
    Vec2 position;            ///< Where it happened: the middle of those concerned [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, subject, value, position);
    }
    /// Equal in all parts.
    friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace muster
