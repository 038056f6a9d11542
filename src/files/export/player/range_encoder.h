// An adaptive binary arithmetic coder: numbers whose distribution is learnt while they are written.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace muster {

/// How likely a bit is 0, learnt from the bits before it, by the mean of a quick and a slow estimate.
class BitModel {
public:
    /// The probability of 0 in shares of 2^15, 1 to 2^15 - 1.
    std::uint32_t zero() const { return (quick_ + slow_) >> 2; }
    /// Learns from a bit.
    void learn(bool bit);

private:
    std::uint32_t quick_ = 1u << 15, slow_ = 1u << 15;  ///< Shares of 2^16.
};

/// The bits of a whole number: how many there are in unary, then the number itself (Elias gamma code of the
/// number + 1), each of the leading bits with a model of its own.
struct NumberModel {
    static constexpr int kLengths = 32;
    std::array<BitModel, kLengths> length;
    std::array<std::array<BitModel, 3>, kLengths> leading;  ///< Of the two bits below the highest.
    BitModel sign;
};

/// Writes bits (range coder with carry, Martin 1979; the layout of the bytes is that of LZMA).
class RangeEncoder {
public:
    /// Writes a bit and teaches its model.
    void bit(BitModel& model, bool bit);
    /// Writes the lowest `count` bits of a value, at most 32, without a model.
    void plain(std::uint32_t value, int count);
    /// Writes a number from 0 to 2^32 - 2.
    void natural(NumberModel& model, std::uint32_t value);
    /// Writes a number of any sign; its magnitude is at most 2^31 - 1.
    void whole(NumberModel& model, std::int32_t value);
    /// The bytes; nothing can be written afterwards.
    std::string finish();
    /// Bytes so far, without those that are held back.
    std::size_t size() const { return bytes_.size(); }

private:
    void narrow(std::uint32_t bound, bool bit);
    void shift();

    std::string bytes_;
    std::uint64_t low_ = 0;
    std::uint32_t range_ = 0xFFFFFFFFu;
    std::uint8_t held_ = 0;        ///< The last byte that a carry may still change.
    std::uint64_t heldCount_ = 1;  ///< It, and the bytes of 0xFF that follow it.
};

}  // namespace muster
