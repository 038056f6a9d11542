#include "base/random.h"

#include <doctest.h>

#include <bit>
#include <cmath>
#include <vector>

using namespace muster;

namespace {

/// PCG-XSH-RR 64/32 as O'Neill's paper states it (HMC-CS-2014-0905, section 6.3), with jumps ahead after
/// Brown 1994.
class ReferencePcg {
public:
    explicit ReferencePcg(std::uint64_t seed) : state_(kIncrement + seed) { advance(1); }

    std::uint32_t next() {
        const std::uint64_t x = state_;
        advance(1);
        return std::rotr(static_cast<std::uint32_t>((x ^ (x >> 18)) >> 27), static_cast<int>(x >> 59));
    }
    /// Skips that many numbers in logarithmic time.
    void advance(std::uint64_t count) {
        std::uint64_t factor = 1, sum = 0, multiplier = 6364136223846793005ull, increment = kIncrement;
        for (; count > 0; count /= 2) {
            if (count % 2 == 1) {
                factor *= multiplier;
                sum = sum * multiplier + increment;
            }
            increment *= multiplier + 1;
            multiplier *= multiplier;
        }
        state_ = factor * state_ + sum;
    }
    std::uint64_t state() const { return state_; }

private:
    static constexpr std::uint64_t kIncrement = 1442695040888963407ull;
    std::uint64_t state_;
};

std::uint64_t stateOf(Random& random) {
    std::uint64_t state = 0;
    const auto archive = [&](std::uint64_t& value) { state = value; };
    random.visit(archive);
    return state;
}

}  // namespace

TEST_CASE("the stream is that of PCG-XSH-RR for every seed") {
    for (const std::uint64_t seed : {0ull, 1ull, 42ull, 0xFFFFFFFFFFFFFFFFull, 0x123456789ABCDEFull}) {
        Random random(seed);
        ReferencePcg reference(seed);
        for (int i = 0; i < 1000; ++i) REQUIRE(random.next() == reference.next());
        CHECK(stateOf(random) == reference.state());
        for (int i = 0; i < 12345; ++i) random.next();
        reference.advance(12345);
        CHECK(stateOf(random) == reference.state());
    }
}

TEST_CASE("a saved state goes on with the same numbers") {
    Random random(7);
    for (int i = 0; i < 100; ++i) random.next();
    const std::uint64_t state = stateOf(random);
    Random other(99);
    const auto load = [&](std::uint64_t& value) { value = state; };
    other.visit(load);
    for (int i = 0; i < 100; ++i) CHECK(other.next() == random.next());
}

TEST_CASE("uniform numbers are multiples of 2^-53 with the moments of a uniform distribution") {
    Random random(12);
    const int count = 200000;
    double sum = 0.0, squares = 0.0, lag = 0.0, last = 0.5;
    bool odd = false;
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform();
        REQUIRE(u >= 0.0);
        REQUIRE(u < 1.0);
        const double whole = std::ldexp(u, 53);
        REQUIRE(whole == std::floor(whole));
        odd = odd || std::fmod(whole, 2.0) == 1.0;
        sum += u;
        squares += u * u;
        lag += (u - 0.5) * (last - 0.5);
        last = u;
    }
    CHECK(odd);  // The lowest bit is used.
    // Bounds are five standard deviations of the means.
    CHECK(std::fabs(sum / count - 0.5) < 5.0 * std::sqrt(1.0 / 12 / count));
    CHECK(std::fabs(squares / count - 1.0 / 3) < 5.0 * std::sqrt(4.0 / 45 / count));
    CHECK(std::fabs(lag / count) < 5.0 / 12 / std::sqrt(count));
    for (int i = 0; i < 1000; ++i) {
        const double u = random.uniform(-2.0, 3.0);
        CHECK(u >= -2.0);
        CHECK(u < 3.0);
    }
    CHECK(random.uniform(4.0, 4.0) == 4.0);
}

TEST_CASE("whole numbers below a bound are equally likely, also where the bound is no power of two") {
    Random random(31);
    for (const std::uint32_t bound : {1u, 2u, 3u, 7u, 10u, 64u}) {
        std::vector<int> counts(bound, 0);
        const int each = 4000;
        for (std::uint32_t i = 0; i < each * bound; ++i) {
            const std::uint32_t k = random.below(bound);
            REQUIRE(k < bound);
            ++counts[k];
        }
        for (const int count : counts) CHECK(std::abs(count - each) <= 5.0 * std::sqrt(each));
    }
    // The remainder of 32 random bits would lie in the lower third half of the time.
    const std::uint32_t large = 3u << 30;
    int low = 0;
    for (int i = 0; i < 60000; ++i) low += random.below(large) < (1u << 30) ? 1 : 0;
    CHECK(std::abs(low - 20000) < 5.0 * std::sqrt(60000 * 2.0 / 9));
}
