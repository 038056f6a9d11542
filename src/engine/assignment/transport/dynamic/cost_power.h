// Costs raised to the exponent of the objective.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/maths.h"
#include "engine/assignment/transport/dynamic/cost_oracle.h"

namespace muster {

/// Raises costs to the power p in a unit of length that keeps the results within single precision.
class CostPower {
public:
    /// Power of the exponent `p`, 1 to 16.
    explicit CostPower(double p = 2.0) : exponent_(p) {
        if (p > 8.0) unit_ = CostOracle::kUnreachable / power(10.0, 32.0 / p);
        whole_ = static_cast<std::int32_t>(p);
        if (p != whole_) whole_ = 0;
    }
    /// `cost` [m] to the power p, in metre^p divided by units().
    double operator()(double cost) const {
        const double c = std::min(cost, static_cast<double>(CostOracle::kUnreachable)) / unit_;
        if (whole_ == 2) return c * c;
        if (whole_ == 0) return power(c, exponent_);
        double product = c;
        for (std::int32_t k = 1; k < whole_; ++k) product *= c;
        return product;
    }
    double exponent() const { return exponent_; }             ///< The exponent p.
    double units() const { return power(unit_, exponent_); }  ///< Factor that brings results back to metre^p.

private:
    double exponent_ = 2.0;
    double unit_ = 1.0;       // Unit of length [m].
    std::int32_t whole_ = 2;  // The exponent if it is a whole number, else 0.
};

}  // namespace muster
