// Events: what happened in a step.
#pragma once

#include "muster/generated/event.h"

namespace muster {

/// The name of a kind: "enterPatch", "arrived"...
const char* eventKindName(EventKind kind);
/// True for the kinds that tell how an order gets on.
constexpr bool isOrderEvent(EventKind kind) {
    return kind >= EventKind::Arrived && kind < EventKind::Count;
}

}  // namespace muster
