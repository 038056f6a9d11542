#include "engine/passages/key_sort.h"

#include <algorithm>
#include <array>

#include "base/maths.h"

namespace muster {
namespace {

constexpr std::size_t kFewKeys = 128;    // Number of keys up to which comparisons sort them.
constexpr std::size_t kManyKeys = 4000;  // Number of keys from which on digits are larger.
constexpr int kLargeDigitBits = 11;      // Bits of a digit.
constexpr int kSmallDigitBits = 8;       // Bits of a digit where there are few keys.

/// Bits in the order of the keys, up to keys that are equal as a float.
std::uint32_t orderedBits(double key) {
    // Zeros have one sign.
    const auto bits = bitCast<std::uint32_t>(static_cast<float>(key) + 0.0f);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

}  // namespace

void KeySort::sortDigits() {
    const int bits = digits_.size() < kManyKeys ? kSmallDigitBits : kLargeDigitBits;
    const std::uint32_t mask = (1u << bits) - 1;
    other_.resize(digits_.size());
    std::array<std::uint32_t, 1u << kLargeDigitBits> end;
    for (int shift = 0; shift < 32; shift += bits) {
        std::fill_n(end.begin(), mask + 1, 0u);
        for (const Digits& d : digits_) ++end[d.bits >> shift & mask];
        std::uint32_t sum = 0;
        for (std::uint32_t digit = 0; digit <= mask; ++digit) end[digit] = sum += end[digit];
        for (std::size_t k = digits_.size(); k > 0; --k) {
            const Digits& d = digits_[k - 1];
            other_[--end[d.bits >> shift & mask]] = d;
        }
        std::swap(digits_, other_);
    }
}

void KeySort::sort(std::vector<SortKey>& keys) {
    if (keys.size() < kFewKeys) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    digits_.clear();
    for (std::size_t k = 0; k < keys.size(); ++k)
        digits_.push_back({orderedBits(keys[k].key), static_cast<std::int32_t>(k)});
    sortDigits();
    before_.assign(keys.begin(), keys.end());
    for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = before_[digits_[k].at];
    // Sorts keys that are equal as a float.
    for (std::size_t first = 0, end = 0; first < keys.size(); first = end) {
        for (end = first + 1; end < keys.size() && digits_[end].bits == digits_[first].bits;) ++end;
        const auto from = keys.begin() + static_cast<std::ptrdiff_t>(first);
        const auto to = keys.begin() + static_cast<std::ptrdiff_t>(end);
        if (!std::is_sorted(from, to)) std::sort(from, to);
    }
}

}  // namespace muster
