// Wall-clock time for reports. No decision of the simulation may depend on it.
#pragma once

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#else
#include <chrono>
#endif

namespace muster {

/// Measures the time since its construction or its last restart.
class Stopwatch {
public:
    /// Milliseconds since the start.
    double milliseconds() const { return now() - start_; }
    /// Restarts the measurement.
    void restart() { start_ = now(); }

private:
    // The time of a clock [ms].
    static double now() {
#ifdef __EMSCRIPTEN__
        return emscripten_get_now();  // The clocks of its C++ library take several times as long.
#else
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
#endif
    }

    double start_ = now();
};

}  // namespace muster
