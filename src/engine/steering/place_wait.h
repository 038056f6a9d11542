// What it costs a character that others bar its way to a place.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

/// The wait of one character.
struct PlaceWait {
    Vec2 anchor;              ///< Where it was when it last got on [m].
    float stood = 0.0f;       ///< Time since then [s].
    std::int32_t place = -1;  ///< A place to which others barred the way; -1 for none.
    float cost = 0.0f;        ///< What is added to the cost of that place [m], 0 or more.

    /// Lets an archive read or write the wait.
    template <class Archive>
    void visit(Archive& archive) {
        archive(anchor, stood, place, cost);
    }
};

}  // namespace muster
