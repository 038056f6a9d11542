// Text as polygons.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/polygon.h"

namespace muster {

/// Converts UTF-8 text to the characters that can be drawn, ASCII 32 to 126: Latin letters without
/// diacritics, "?" for each other code point and for invalid bytes.
std::string plainLetters(std::string_view words);

/// Appends the strokes of a line of text, in plain letters, that starts at x = 0 and is centred on y = 0
/// [px], y downwards; 200 letters at most. Returns its width [px].
double letterLoops(std::string_view words, double size, std::vector<std::vector<Vec2>>& loops);

}  // namespace muster
