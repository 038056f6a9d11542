// Jumping.
#pragma once

#include <vector>

#include "muster/clip.h"

namespace muster::generator {

/// "jump" (a running jump with feet tucked) and "jump-over" (over a low thing, one leg leading).
void addJumps(std::vector<Clip>& clips);

}  // namespace muster::generator
