#include "files/export/player/range_encoder.h"

#include <bit>

namespace muster {
namespace {

constexpr int kQuick = 4, kSlow = 7;  // Estimates move by these shares, as powers of 1/2.
constexpr std::uint32_t kWhole = (1u << 16) - 1;
constexpr int kShareBits = 15;
constexpr std::uint32_t kLeastRange = 1u << 24;

}  // namespace

void BitModel::learn(bool bit) {
    if (bit) {
        quick_ -= quick_ >> kQuick;
        slow_ -= slow_ >> kSlow;
    } else {
        quick_ += (kWhole - quick_) >> kQuick;
        slow_ += (kWhole - slow_) >> kSlow;
    }
}

void RangeEncoder::bit(BitModel& model, bool bit) {
    narrow((range_ >> kShareBits) * model.zero(), bit);
    model.learn(bit);
}

void RangeEncoder::plain(std::uint32_t value, int count) {
    for (int k = count - 1; k >= 0; --k) narrow(range_ >> 1, (value >> k & 1u) != 0);
}

void RangeEncoder::natural(NumberModel& model, std::uint32_t value) {
    const std::uint32_t shifted = value + 1;
    const int length = std::bit_width(shifted) - 1;
    for (int k = 0; k < length; ++k) bit(model.length[static_cast<std::size_t>(k)], true);
    if (length < NumberModel::kLengths - 1) bit(model.length[static_cast<std::size_t>(length)], false);
    auto& leading = model.leading[static_cast<std::size_t>(length)];
    int left = length;
    std::size_t seen = 0;
    for (int k = 0; k < 2 && left > 0; ++k) {
        const bool one = (shifted >> --left & 1u) != 0;
        bit(leading[seen], one);
        seen = one ? 2 : 1;
    }
    plain(shifted, left);
}

void RangeEncoder::whole(NumberModel& model, std::int32_t value) {
    natural(model, value < 0 ? 0u - static_cast<std::uint32_t>(value) : static_cast<std::uint32_t>(value));
    if (value != 0) bit(model.sign, value < 0);
}

std::string RangeEncoder::finish() {
    for (int k = 0; k < 5; ++k) shift();
    return std::move(bytes_);
}

void RangeEncoder::narrow(std::uint32_t bound, bool bit) {
    if (bit) {
        low_ += bound;
        range_ -= bound;
    } else {
        range_ = bound;
    }
    while (range_ < kLeastRange) {
        range_ <<= 8;
        shift();
    }
}

void RangeEncoder::shift() {
    const bool carry = (low_ >> 32) != 0;
    if (carry || static_cast<std::uint32_t>(low_) < 0xFF000000u) {
        for (; heldCount_ > 0; --heldCount_) {
            bytes_ += static_cast<char>(static_cast<std::uint8_t>(held_ + (carry ? 1 : 0)));
            held_ = 0xFF;
        }
        held_ = static_cast<std::uint8_t>(low_ >> 24);
    }
    ++heldCount_;
    low_ = (low_ & 0x00FFFFFFu) << 8;
}

}  // namespace muster
