// What happens in a take, for the time line.
#pragma once

#include <vector>

#include "muster/take.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Touches with their lengths, orders, other commands and events, in ascending order of steps; at most 2,000.
/// Of more, later ones of the same kind and label within a quarter of a second are left out, then the rest.
std::vector<protocol::TakeMark> takeMarks(const Take& take);

}  // namespace muster
