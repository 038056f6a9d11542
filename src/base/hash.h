// The hash of simulated state.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/maths.h"

namespace muster {

/// Accumulates a 64-bit hash of typed values (FNV-1a over 64-bit words, with a final mix).
/// Lengths go in as 32-bit numbers, never as size_t, so that every platform agrees.
class Hash {
public:
    /// Adds one word.
    void addWord(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x100000001b3ull;
        state_ ^= state_ >> 29;
    }
    /// Adds the bits of a double; both zeros count as one.
    void add(double value) { addWord(bitCast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }
    /// Adds the bits of a float; both zeros count as one.
    void add(float value) { addWord(bitCast<std::uint32_t>(value == 0.0f ? 0.0f : value)); }
    /// Adds a whole number.
    void add(std::uint64_t value) { addWord(value); }
    void add(std::uint32_t value) { addWord(value); }                             ///< Adds a whole number.
    void add(std::int32_t value) { addWord(static_cast<std::uint32_t>(value)); }  ///< Adds a whole number.
    void add(std::uint8_t value) { addWord(value); }                              ///< Adds a whole number.
    void add(bool value) { addWord(value ? 1u : 0u); }                            ///< Adds a flag.
    /// Adds length and bytes.
    void add(const std::string& text) {
        add(static_cast<std::uint32_t>(text.size()));
        for (char c : text) addWord(static_cast<unsigned char>(c));
    }
    /// The hash of all added so far.
    std::uint64_t value() const {
        std::uint64_t h = state_;
        h ^= h >> 33;
        h *= 0xff51afd7ed558ccdull;
        h ^= h >> 33;
        h *= 0xc4ceb9fe1a85ec53ull;
        return h ^ (h >> 33);
    }

    /// The hash as a random number in (0, 1), of 53 bits: the same values give the same number, whatever else
    /// is drawn.
    double randomShare() const {
        constexpr double kBits = 1.0 / 9007199254740992.0;  // 2 to the power -53.
        return (static_cast<double>(value() >> 11) + 0.5) * kBits;
    }

private:
    std::uint64_t state_ = 0xcbf29ce484222325ull;
};

/// The hash as 16 hexadecimal digits.
std::string toHex(std::uint64_t hash);

/// CRC-32 (IEEE 802.3) of `bytes`, going on from `seed` (the value of a former call).
std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t seed = 0);

}  // namespace muster
