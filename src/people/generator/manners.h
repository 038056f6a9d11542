// Manners of walking beside the plain one: the motion sets.
#pragma once

#include <vector>

#include "muster/clip.h"

namespace muster::generator {

/// Appends the gaits of all motion sets: "march-walk", "march-walk-left", "weary-jog"...
void addMotionSets(std::vector<Clip>& clips);

}  // namespace muster::generator
