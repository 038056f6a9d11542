// Text as little areas.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/polygon.h"

namespace muster {

/// UTF-8 text in the letters that can be drawn, ASCII 32 to 126: Latin letters without their marks, "?" for
/// each other code point and for bytes that are no UTF-8.
std::string plainLetters(std::string_view words);

/// Appends the strokes of a line of text, in plain letters, that starts at x = 0 and is centred on y = 0
/// [px], y downwards; 200 letters at most. Returns its width [px].
double letterLoops(std::string_view words, double size, std::vector<std::vector<Vec2>>& loops);

}  // namespace muster
