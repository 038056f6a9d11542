// A hand never draws the same way twice.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/command.h"

namespace muster {

/// Moves the drawing of all fingers aside by one vector that the seed chooses, each component up to `amount`
/// [m] >= 0. The shift grows over two seconds from the first touch, so that nothing jumps. Fingers go down
/// where they did.
void jitterHand(std::vector<Command>& commands, std::uint64_t seed, double amount);

}  // namespace muster
