// Costs between characters and places, asked for by number.
#pragma once

#include <cstdint>
#include <span>

#include "base/parallel.h"

namespace muster {

/// A character and a place by number.
struct Pair {
    std::int32_t character = 0;  ///< Row.
    std::int32_t place = 0;      ///< Column.
};

/// What it costs now to bring a character to a place. Answers stay the same within a step.
class PairCosts {
public:
    /// From this on a cost means that there is practically no way [m].
    static constexpr float kNoWay = 1e4f;

    virtual ~PairCosts() = default;
    /// The cost of one pair [m] >= 0, finite.
    virtual float cost(std::int32_t character, std::int32_t place) = 0;
    /// No cost is less than so many times the straight line, >= 0.
    virtual double perMetre() const { return 0.0; }
    /// A closer bound of one pair, worked out from where both are [m] >= 0.
    virtual double atLeast(std::int32_t, std::int32_t) const { return 0.0; }
    /// True where moving things are near the character or the place: there costs change from step to step.
    virtual bool unsteady(std::int32_t, std::int32_t) const { return false; }
    /// The costs of many pairs, worked out side by side; `cost` is as long as `pairs`.
    virtual void fill(std::span<const Pair> pairs, std::span<float> cost, ThreadPool& pool) = 0;
};

}  // namespace muster
