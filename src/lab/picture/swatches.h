// Colours that the page offers for groups, each for light and for dark backgrounds.
#pragma once

#include <cstdint>

namespace muster {

/// How a chosen colour, 0xRRGGBB, looks on a dark background: the other of its pair; other colours stay.
std::uint32_t darkSwatch(std::uint32_t colour);

}  // namespace muster
