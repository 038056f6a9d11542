#include "muster/event.h"

#include <cstddef>

#include "base/generated/enumeration_words.h"

namespace muster {

const char* eventKindName(EventKind kind) {
    return kind < EventKind::Count ? kEventKindWords[static_cast<std::size_t>(kind)] : "";
}

}  // namespace muster
