// Random times and errors of an operator model, the same on every machine.
#pragma once

#include "base/random.h"
#include "muster/vec2.h"

namespace muster {

/// Draws for one model. No function of the C library is used but sqrt.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : random_(seed) {}

    /// Standard normal: twelve uniform numbers less six; its tails end at six deviations.
    double normal();
    /// Gamma of mean 1 and this coefficient of variation, by Wilson and Hilferty 1931; at least 0.05.
    double gamma(double variation);
    /// e to the power of a normal number of this deviation.
    double logNormal(double deviation);
    /// Normal in both axes with these deviations.
    Vec2 scatter(double deviation) { return {deviation * normal(), deviation * normal()}; }
    /// Uniform in [0, 1).
    double uniform() { return random_.uniform(); }
    /// A whole number in [0, bound).
    std::uint32_t below(std::uint32_t bound) { return random_.below(bound); }

private:
    Random random_;
};

}  // namespace muster
