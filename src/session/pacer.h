// From real time to steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace muster {

/// Owes steps for the time that passes; debts beyond two batches are forgiven, so that a slow machine slows
/// the world instead of falling ever further behind.
class Pacer {
public:
    /// Real time passes [s] at `speed` times the world's.
    void elapse(double seconds, double speed, double stepTime) {
        const double most = 2.0 * batch(speed) * stepTime;
        owed_ = std::min(owed_ + std::max(0.0, seconds) * speed, most);
    }
    /// True where a step is owed; `eager` where one may be made ahead of time, as somebody waits for its
    /// effect.
    bool due(double stepTime, bool eager) const { return owed_ >= threshold(stepTime, eager) - kSlack; }
    /// A step was made. One made ahead of time is owed back: the next comes no earlier than it would have.
    void pay(double stepTime) { owed_ = std::max(-stepTime, owed_ - stepTime); }
    /// Real time until a step is due [s].
    double until(double speed, double stepTime, bool eager) const {
        return std::max(0.0, (threshold(stepTime, eager) - owed_) / speed);
    }
    /// Nothing is owed.
    void reset() { owed_ = 0.0; }
    /// Most steps between two looks at the clients.
    static std::int32_t batch(double speed) {
        return std::max(1, static_cast<std::int32_t>(std::ceil(speed)));
    }

private:
    static double threshold(double stepTime, bool eager) { return eager ? 0.0 : stepTime; }

    static constexpr double kSlack = 1e-6;  // Rounding of clocks [s].
    double owed_ = 0.0;                     // World time [s].
};

}  // namespace muster
