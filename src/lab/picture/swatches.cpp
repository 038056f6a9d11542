#include "lab/picture/theme.h"

#include <array>

namespace muster {
namespace {

/// One colour for light and for dark backgrounds.
struct Swatch {
    std::uint32_t light, dark;
};

// As in web/src/model/swatches.ts.
constexpr std::array<Swatch, 12> kSwatches{{{0x1D5FD1, 0x74A9FF},
                                            {0xCB4A0E, 0xFF8A4C},
                                            {0x016553, 0x90FBC9},
                                            {0x87598B, 0xAC6BAA},
                                            {0x624A02, 0xFBE24F},
                                            {0x313C4B, 0xB7BCC2},
                                            {0xD60EA8, 0xE47AD0},
                                            {0x05536D, 0x17D7FF},
                                            {0x6A7A42, 0x7F8430},
                                            {0x440E93, 0xAA5AFC},
                                            {0x5C1A0C, 0xBD8B7F},
                                            {0x08090B, 0xFFFFFF}}};

}  // namespace

std::uint32_t darkSwatch(std::uint32_t colour) {
    for (const Swatch& swatch : kSwatches)
        if (swatch.light == colour) return swatch.dark;
    return colour;
}

}  // namespace muster
