#include "muster/event.h"

#include <array>
#include <cstddef>

namespace muster {

const char* eventKindName(EventKind kind) {
    static constexpr std::array<const char*, static_cast<std::size_t>(EventKind::Count)> kNames = {
        "enterPatch",      "leavePatch", "transitionStart", "transitionEnd", "singleStep", "collect",
        "formationChange", "swap",       "arrived",         "stuck",         "blocked",    "free",
        "noPath",          "partial",    "orderGiven",      "orderBegun",    "orderDone",  "orderSkipped",
        "passed",          "groupAdded", "groupRemoved",    "joined",        "left",       "transferred",
        "exited",          "entered"};
    return kind < EventKind::Count ? kNames[static_cast<std::size_t>(kind)] : "";
}

}  // namespace muster
