// The clip of climbing over a wall.
#pragma once

#include "muster/clip.h"

namespace muster::generator {

/// The clip "climb": over a wall 1.3 m high and 0.4 m thick.
Clip climbClip();

}  // namespace muster::generator
