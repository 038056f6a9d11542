// Text as little areas.
#pragma once

#include <string_view>
#include <vector>

#include "muster/geometry/polygon.h"

namespace muster {

/// Appends the strokes of a line of ASCII text that starts at x = 0 and is centred on y = 0 [px], y downwards.
/// Returns its width [px].
double letterLoops(std::string_view words, double size, std::vector<std::vector<Vec2>>& loops);

}  // namespace muster
