// Seeded random numbers whose state can be saved.
#pragma once

#include <cstdint>

namespace muster {

/// PCG32 (O'Neill 2014): small, portable, the same stream everywhere.
class Random {
public:
    /// Different seeds give different streams.
    explicit Random(std::uint64_t seed = 0);

    /// The next 32 random bits.
    std::uint32_t next();
    /// Uniform in [0, 1), 53 bits.
    double uniform();
    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// A whole number in [0, bound), bound > 0, without bias.
    std::uint32_t below(std::uint32_t bound);

    /// Lets an archive read or write the state.
    template <class Archive>
    void visit(Archive& archive) {
        archive(state_);
    }

private:
    std::uint64_t state_ = 0;
};

}  // namespace muster
