// Hashes of inputs that differ by little; checksums against a bitwise one.
#include <doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/archive.h"
#include "base/hash.h"
#include "base/random.h"

using namespace muster;

namespace {

template <class... T>
std::uint64_t hashOf(const T&... values) {
    Hash hash;
    (hash.add(values), ...);
    return hash.value();
}

template <class T>
std::uint64_t archived(T value) {
    Hasher hasher;
    hasher(value);
    return hasher.value();
}

/// CRC-32 by its definition: one bit at a time.
std::uint32_t slowCrc(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t c = 0xffffffffu;
    for (const std::uint8_t byte : bytes) {
        for (int bit = 0; bit < 8; ++bit) {
            const bool odd = ((c ^ (byte >> bit)) & 1u) != 0;
            c = (c >> 1) ^ (odd ? 0xedb88320u : 0u);
        }
    }
    return ~c;
}

}  // namespace

TEST_CASE("near numbers never share a hash") {
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < 50000; ++i) seen.insert(hashOf(i));
    double value = 1.0;
    for (int i = 0; i < 50000; ++i) {
        value = std::nextafter(value, 2.0);
        seen.insert(hashOf(value));
    }
    CHECK(seen.size() == 100000);
}

TEST_CASE("pairs of small numbers never share a hash, and their order counts") {
    std::set<std::uint64_t> seen;
    for (std::uint32_t a = 0; a < 300; ++a) {
        for (std::uint32_t b = 0; b < 300; ++b) seen.insert(hashOf(a, b));
    }
    CHECK(seen.size() == 90000);
}

TEST_CASE("points of a lattice a nanometre wide never share a hash") {
    std::set<std::uint64_t> seen;
    for (int x = -100; x < 100; ++x) {
        for (int y = -100; y < 100; ++y) seen.insert(archived(Vec2{3.25 + x * 1e-9, -7.5 + y * 1e-9}));
    }
    CHECK(seen.size() == 40000);
}

TEST_CASE("one flipped bit changes half of the hash") {
    Random random(5);
    double changed = 0.0;
    int fewest = 64;
    for (int i = 0; i < 4000; ++i) {
        const std::uint64_t word = (std::uint64_t{random.next()} << 32) | random.next();
        const std::uint64_t other = word ^ (1ull << (i % 64));
        const int bits = std::popcount(hashOf(word) ^ hashOf(other));
        changed += bits / 4000.0;
        fewest = std::min(fewest, bits);
    }
    CHECK(changed == doctest::Approx(32.0).epsilon(0.02));
    CHECK(fewest >= 8);
}

TEST_CASE("where one thing ends and the next begins counts") {
    using Text = std::string;
    CHECK(hashOf(Text("ab"), Text("c")) != hashOf(Text("a"), Text("bc")));
    CHECK(hashOf(Text("")) != hashOf());
    CHECK(hashOf(Text("a")) != hashOf(Text("a\0", 2)));
    using Lists = std::vector<std::vector<std::int32_t>>;
    CHECK(archived(Lists{{1}, {}}) != archived(Lists{{}, {1}}));
    CHECK(archived(Lists{{1, 2}}) != archived(Lists{{1}, {2}}));
    CHECK(archived(Lists{}) != archived(Lists{{}}));
    CHECK(archived(std::optional<std::int32_t>{}) != archived(std::optional<std::int32_t>{0}));
}

TEST_CASE("a sign, a flag and the sign of zero") {
    CHECK(hashOf(std::int32_t{-1}) != hashOf(std::int32_t{1}));
    CHECK(hashOf(-1.0) != hashOf(1.0));
    CHECK(hashOf(true) != hashOf(false));
    CHECK(hashOf(0.0f) == hashOf(-0.0f));
    CHECK(archived(Vec2{0.0, -0.0}) == archived(Vec2{-0.0, 0.0}));
    CHECK(hashOf(1.0f) != hashOf(1.0));
    CHECK(hashOf(5e-324) != hashOf(0.0));
}

TEST_CASE("hexadecimal digits say the number") {
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        const std::uint64_t word = (std::uint64_t{random.next()} << 32) | random.next();
        const std::string text = toHex(word);
        CHECK(text.size() == 16);
        CHECK(std::stoull(text, nullptr, 16) == word);
    }
    CHECK(toHex(~0ull) == "ffffffffffffffff");
    CHECK(toHex(0) == "0000000000000000");
}

TEST_CASE("CRC-32 agrees with one made bit by bit, whole and in pieces, and notices any change of a byte") {
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        std::vector<std::uint8_t> bytes(random.below(70));
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
        const std::uint32_t whole = crc32(bytes);
        CHECK(whole == slowCrc(bytes));
        const std::size_t cut = bytes.empty() ? 0 : random.below(static_cast<std::uint32_t>(bytes.size()));
        CHECK(crc32(std::span(bytes).subspan(cut), crc32(std::span(bytes).first(cut))) == whole);
        if (bytes.empty()) continue;
        bytes[cut] = static_cast<std::uint8_t>(bytes[cut] ^ (1u << random.below(8)));
        CHECK(crc32(bytes) != whole);
    }
    CHECK(crc32({}) == 0u);
}
