// A take whose commands were changed, made ready to be simulated again.
#pragma once

#include <cstdint>

#include "muster/take.h"

namespace muster {

/// Puts commands in the order in which they apply and leaves out those after that many steps. Its marks wait
/// for their hashes; neither events nor frames are left.
void runAgain(Take& take, std::uint32_t steps);

}  // namespace muster
