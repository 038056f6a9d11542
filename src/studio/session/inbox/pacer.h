// Converts real time to steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace muster {

/// Time until somebody looks again where nothing moves and nothing is awaited [s].
inline constexpr double kLongWait = 1.0;

/// Schedules steps by real time. A backlog beyond two batches is dropped, so that a slow machine slows the
/// world instead of falling further and further behind.
class Pacer {
public:
    /// Advances real time by `seconds`; the world runs at `speed` times real time.
    void elapse(double seconds, double speed, double stepTime) {
        const double most = 2.0 * batch(speed) * stepTime;
        owed_ = std::min(owed_ + std::max(0.0, seconds) * speed, most);
    }
    /// True where a step is due. With `eager`, a step may come early, because a client waits for its effect.
    bool due(double stepTime, bool eager) const { return owed_ >= threshold(stepTime, eager) - kSlack; }
    /// Records a step. After an early step the next one comes no sooner than it would have come otherwise.
    void pay(double stepTime) { owed_ = std::max(-stepTime, owed_ - stepTime); }
    /// Real time until the next step is due [s].
    double until(double speed, double stepTime, bool eager) const {
        return std::max(0.0, (threshold(stepTime, eager) - owed_) / speed);
    }
    /// Clears the backlog.
    void reset() { owed_ = 0.0; }
    /// Largest number of steps between two reads of the clients' messages.
    static std::int32_t batch(double speed) {
        return std::max(1, static_cast<std::int32_t>(std::ceil(speed)));
    }

private:
    static double threshold(double stepTime, bool eager) { return eager ? 0.0 : stepTime; }

    static constexpr double kSlack = 1e-6;  // Tolerance for rounding of clocks [s].
    double owed_ = 0.0;                     // World time that is due and not yet stepped [s].
};

}  // namespace muster
