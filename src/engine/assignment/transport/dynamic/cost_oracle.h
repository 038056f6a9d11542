// The interface that gives the costs of single pairs.
#pragma once

#include <cstdint>
#include <span>

#include "base/parallel.h"

namespace muster {

/// A character and a place by index: one entry of the cost matrix.
struct AssignmentPair {
    std::int32_t character = 0;  ///< Index of the row.
    std::int32_t place = 0;      ///< Index of the column.
};

/// Gives the cost of bringing a character to a place, so that no cost matrix has to exist. Answers to the
/// same question are equal within one call of DynamicAssignment.
class CostOracle {
public:
    /// Costs from this value on stand for an unreachable place [m].
    static constexpr float kUnreachable = 1e4f;

    virtual ~CostOracle() = default;
    /// The cost of one pair [m] >= 0, finite.
    virtual float cost(std::int32_t character, std::int32_t place) = 0;
    /// Evaluates many pairs in parallel; `cost` is as long as `pairs` [m].
    virtual void evaluate(std::span<const AssignmentPair> pairs, std::span<float> cost, ThreadPool& pool) = 0;
    /// A lower bound of the cost per metre of straight distance, >= 0, for all pairs.
    virtual double leastUnitCost() const { return 0.0; }
    /// A tighter lower bound of the cost of one pair [m] >= 0.
    virtual double lowerBound(std::int32_t /*character*/, std::int32_t /*place*/) const { return 0.0; }
    /// True where the cost of the pair may change much from step to step, so that it is refreshed more often.
    virtual bool unsteady(std::int32_t /*character*/, std::int32_t /*place*/) const { return false; }
};

}  // namespace muster
