// The order in which commands are applied.
#pragma once

#include <tuple>

#include "muster/command.h"

namespace muster {

/// The order in which commands are applied.
inline bool comesBefore(const Command& a, const Command& b) {
    return std::tie(a.step, a.client, a.sequence) < std::tie(b.step, b.client, b.sequence);
}

}  // namespace muster
