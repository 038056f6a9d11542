// Definitions as they are made at first.
#pragma once

#include "bindings/c/c_world/world_fields.h"

namespace muster::c_api {

/// The engine's default as a C struct. Its arrays and texts live as long as the process.
template <class A, class B>
const A& defaultOf() {
    static const B& value = *new B{};
    static Arena& arena = *new Arena;
    static const A made = writeC<A>(value, arena);
    return made;
}

}  // namespace muster::c_api
