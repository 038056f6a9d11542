// Random numbers that are the same everywhere (splitmix64), for the emulated network and the scripts of
// players.
#pragma once

#include <cstdint>

namespace lockstep {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// A number in [0, count), count above 0.
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(next() % count); }
    /// A number in [low, high).
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1.0p-53;
    }
    /// True with this probability.
    bool chance(double probability) { return between(0.0, 1.0) < probability; }

private:
    std::uint64_t state_;
};

}  // namespace lockstep
