// The clips of jumping.
#pragma once

#include <vector>

#include "muster/clip.h"

namespace muster::generator {

/// Adds "jump" (a running jump with tucked feet) and "jump-over" (over a low obstacle, one leg leading).
void addJumps(std::vector<Clip>& clips);

}  // namespace muster::generator
