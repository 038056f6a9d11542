// Random times and errors of an operator model, the same on every machine.
#pragma once

#include "base/random.h"
#include "muster/vec2.h"

namespace muster {

/// Draws for one model. No function of the C library is used but sqrt.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : random_(seed) {}

    /// Draws a standard normal number: twelve uniform numbers less six; its tails end at six deviations.
    double normal();
    /// Draws a gamma number of mean 1 and this coefficient of variation, by Wilson and Hilferty 1931; at
    /// least 0.05.
    double gamma(double variation);
    /// Draws e to the power of a normal number of this deviation.
    double logNormal(double deviation);
    /// Draws a normal number for each axis, with this deviation.
    Vec2 scatter(double deviation) { return {deviation * normal(), deviation * normal()}; }
    /// Draws a uniform number in [0, 1).
    double uniform() { return random_.uniform(); }
    /// Draws a whole number in [0, bound).
    std::uint32_t below(std::uint32_t bound) { return random_.below(bound); }

private:
    Random random_;
};

}  // namespace muster
