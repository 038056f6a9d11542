// Looks as text: colours as "#rrggbb", and the words of appearances in files and messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/generated/enumeration_words.h"

namespace muster {

/// The colour 0xRRGGBB as "#rrggbb", in small letters.
inline std::string colourText(std::uint32_t colour) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[colour >> shift & 15u];
    return text;
}

/// The colour that such a text names, in small or capital letters; none for other texts.
inline std::optional<std::uint32_t> parseColour(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::uint32_t colour = 0;
    for (const char c : text.substr(1)) {
        const bool number = c >= '0' && c <= '9', small = c >= 'a' && c <= 'f', large = c >= 'A' && c <= 'F';
        if (!number && !small && !large) return std::nullopt;
        colour = colour << 4 | static_cast<std::uint32_t>(number  ? c - '0'
                                                          : small ? c - 'a' + 10
                                                                  : c - 'A' + 10);
    }
    return colour;
}

}  // namespace muster
