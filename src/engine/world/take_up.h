// Going on with a world otherwise than it was recorded.
#pragma once

#include <cstddef>

namespace muster {

class World;

/// Drops the commands that wait for the next step or a later one. Returns how many there were.
std::size_t dropWaitingCommands(World& world);

}  // namespace muster
