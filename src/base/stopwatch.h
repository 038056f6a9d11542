// Wall-clock time for reports; never read by a decision.
#pragma once

#include <chrono>

namespace muster {

/// Measures from its making or last restart.
class Stopwatch {
public:
    /// Milliseconds since the start.
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }
    /// Starts again from now.
    void restart() { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace muster
