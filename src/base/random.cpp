#include "base/random.h"

namespace muster {
namespace {
constexpr std::uint64_t kMultiplier = 6364136223846793005ull;
constexpr std::uint64_t kIncrement = 1442695040888963407ull;
}  // namespace

Random::Random(std::uint64_t seed) {
    next();
    state_ += seed;
    next();
}

std::uint32_t Random::next() {
    const std::uint64_t old = state_;
    state_ = old * kMultiplier + kIncrement;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto rotation = static_cast<std::uint32_t>(old >> 59);
    return (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
}

double Random::uniform() {
    const std::uint64_t high = next() >> 5;
    const std::uint64_t low = next() >> 6;
    return static_cast<double>((high << 26) | low) * (1.0 / 9007199254740992.0);
}

std::uint32_t Random::below(std::uint32_t bound) {
    // Rejects values that would make some results more likely than others.
    const std::uint32_t threshold = (0u - bound) % bound;
    for (;;) {
        const std::uint32_t bits = next();
        if (bits >= threshold) return bits % bound;
    }
}

}  // namespace muster
