// Colours to look for in pictures, and another library that decodes PNG files.
#pragma once

#include "lab/picture/debug_draw.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace muster::testing {

inline constexpr Colour kWhite = Colour::of(0xFFFFFF), kBlack = Colour::of(0x000000);

}  // namespace muster::testing
