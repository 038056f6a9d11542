#include "files/export/player/player_format.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"

namespace muster {
namespace {

void putWord(std::string& out, std::uint32_t value) {
    for (int k = 0; k < 4; ++k) out += static_cast<char>(value >> (8 * k) & 255u);
}

}  // namespace

std::int32_t unitsOf(double value, double unit) {
    return static_cast<std::int32_t>(std::clamp(std::floor(value / unit + 0.5), -1e9, 1e9));
}

void PlayerFile::add(std::string_view tag, std::string_view bytes) {
    parts_ += tag;
    putWord(parts_, static_cast<std::uint32_t>(bytes.size()));
    parts_ += bytes;
}

std::string PlayerFile::bytes() const {
    std::string out(kPlayerMagic);
    putWord(out, kPlayerVersion);
    putWord(out, static_cast<std::uint32_t>(kPlayerHeadBytes + parts_.size()));
    putWord(out, crc32({reinterpret_cast<const std::uint8_t*>(parts_.data()), parts_.size()}));
    return out + parts_;
}

}  // namespace muster
