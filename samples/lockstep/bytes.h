// Numbers as bytes, the lowest first, on every machine alike.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lockstep {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

/// Appends a number.
template <std::unsigned_integral Number>
void put(Bytes& bytes, Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
}

/// Appends bytes.
inline void put(Bytes& bytes, ByteSpan more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Reads numbers. Once there are too few bytes it gives zeros and is no longer ok().
class ByteReader {
public:
    explicit ByteReader(ByteSpan bytes) : bytes_(bytes) {}

    template <std::unsigned_integral Number>
    Number get() {
        std::uint64_t value = 0;
        const ByteSpan part = take(sizeof(Number));
        for (std::size_t i = 0; i < part.size(); ++i) value |= std::uint64_t{part[i]} << (8 * i);
        return static_cast<Number>(value);
    }
    /// The next `count` bytes; none where there are fewer.
    ByteSpan take(std::size_t count) {
        ok_ = ok_ && count <= bytes_.size();
        if (!ok_) return {};
        const ByteSpan part = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return part;
    }
    bool ok() const { return ok_; }
    bool atEnd() const { return ok_ && bytes_.empty(); }

private:
    ByteSpan bytes_;
    bool ok_ = true;
};

}  // namespace lockstep
