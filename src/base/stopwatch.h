// Wall-clock time for reports. No decision of the simulation may depend on it.
#pragma once

#include <chrono>

namespace muster {

/// Measures the time since its construction or its last restart.
class Stopwatch {
public:
    /// Milliseconds since the start.
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }
    /// Restarts the measurement.
    void restart() { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace muster
