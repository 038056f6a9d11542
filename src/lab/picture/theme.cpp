#include "lab/picture/theme.h"

#include <algorithm>

namespace muster {
namespace {

constexpr Theme kLight{Colour::of(0xE6E1D9),
                       Colour::of(0x8A8377, 0.10),
                       Colour::of(0x8A8377, 0.22),
                       Colour::of(0x171B20),
                       Colour::of(0x545C66),
                       Colour::of(0xFFFFFF, 0.94),
                       Colour::of(0xCFC8BC),
                       Colour::of(0x777166),
                       Colour::of(0x777166, 0.34),
                       Colour::of(0x171B20, 0.13),
                       Colour::of(0x2F7896),
                       Colour::of(0x6A5A36),
                       Colour::of(0x7A604A),
                       Colour::of(0x4F7340),
                       Colour::of(0x87598B),
                       Colour::of(0x777166),
                       {Colour::of(0x1D5FD1), Colour::of(0xCB4A0E), Colour::of(0x016553),
                        Colour::of(0x87598B), Colour::of(0x624A02), Colour::of(0x313C4B)},
                       {Colour::of(0xF5F3C9), Colour::of(0xA1D1A3), Colour::of(0x4BA9A0),
                        Colour::of(0x3A758F), Colour::of(0x3B4564)}};

constexpr Theme kDark{Colour::of(0x21262C),
                      Colour::of(0xB1B9C2, 0.07),
                      Colour::of(0xB1B9C2, 0.15),
                      Colour::of(0xEEF1F4),
                      Colour::of(0xB1B9C2),
                      Colour::of(0x1F2429, 0.94),
                      Colour::of(0x39414A),
                      Colour::of(0x6C7884),
                      Colour::of(0x6C7884, 0.40),
                      Colour::of(0x000000, 0.30),
                      Colour::of(0x6FB6D2),
                      Colour::of(0xC9B67F),
                      Colour::of(0xB99C82),
                      Colour::of(0x86B173),
                      Colour::of(0xAC6BAA),
                      Colour::of(0x6C7884),
                      {Colour::of(0x74A9FF), Colour::of(0xFF8A4C), Colour::of(0x90FBC9), Colour::of(0xAC6BAA),
                       Colour::of(0xFBE24F), Colour::of(0xB7BCC2)},
                      {Colour::of(0xD6D4AA), Colour::of(0x82B185), Colour::of(0x238881), Colour::of(0x17566E),
                       Colour::of(0x1E2744)}};

}  // namespace

const Theme& Theme::of(bool dark) {
    return dark ? kDark : kLight;
}

Colour Theme::shade(double share) const {
    const double along = std::clamp(share, 0.0, 1.0) * 4.0;
    const auto index = std::min<std::size_t>(3, static_cast<std::size_t>(along));
    const double t = along - static_cast<double>(index);
    const Colour a = ramp[index], b = ramp[index + 1];
    const auto mix = [&](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(x + (y - x) * t + 0.5);
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), 1.0};
}

Colour Pen::accent(std::size_t group, double opacity) const {
    const bool there = group < world.groupCount();
    if (const auto chosen = there ? world.group(group).colour : std::nullopt)
        return faded(Colour::of(def.dark ? darkSwatch(*chosen) : *chosen), opacity);
    return faded(theme.accents[group % theme.accents.size()], opacity);
}

}  // namespace muster
