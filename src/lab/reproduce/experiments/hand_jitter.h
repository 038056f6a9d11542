// Random variation of drawn paths: a hand never draws the same path twice.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/command.h"

namespace muster {

/// Shifts the drawing of all fingers by one vector that the seed chooses, each component up to `amount`
/// [m] >= 0. The shift grows over two seconds from the first touch, so that nothing jumps. The points where
/// fingers go down do not change.
void jitterHand(std::vector<Command>& commands, std::uint64_t seed, double amount);

}  // namespace muster
