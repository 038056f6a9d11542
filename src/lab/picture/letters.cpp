#include "lab/picture/canvas.h"

namespace muster {
namespace {

// The replacements of U+00C0 to U+017F.
constexpr std::string_view kLatin =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLl"
    "NnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
constexpr std::uint32_t kLatinFirst = 0xC0;
static_assert(kLatin.size() == 0x180 - kLatinFirst);

constexpr char kUnknown = '?';

/// Bytes that follow the first one of a UTF-8 sequence; 0 for a byte that begins none.
std::size_t followers(unsigned char first) {
    if (first >= 0xC2 && first < 0xE0) return 1;
    if (first >= 0xE0 && first < 0xF0) return 2;
    return first >= 0xF0 && first < 0xF5 ? 3 : 0;
}

char plainLetter(std::uint32_t codePoint) {
    if (codePoint >= 32 && codePoint <= 126) return static_cast<char>(codePoint);
    const std::uint32_t latin = codePoint - kLatinFirst;
    return latin < kLatin.size() ? kLatin[latin] : kUnknown;
}

}  // namespace

std::string plainLetters(std::string_view words) {
    std::string plain;
    for (std::size_t i = 0; i < words.size();) {
        const auto first = static_cast<unsigned char>(words[i]);
        const std::size_t more = followers(first);
        std::uint32_t codePoint = more == 0 ? first : first & (0x3Fu >> more);
        std::size_t used = 1;
        for (; used <= more && i + used < words.size(); ++used) {
            const auto byte = static_cast<unsigned char>(words[i + used]);
            if ((byte & 0xC0u) != 0x80u) break;
            codePoint = codePoint << 6 | (byte & 0x3Fu);
        }
        const bool whole = used == more + 1 && (more > 0 || first < 128);
        plain += whole ? plainLetter(codePoint) : kUnknown;
        i += used;
    }
    return plain;
}

}  // namespace muster
