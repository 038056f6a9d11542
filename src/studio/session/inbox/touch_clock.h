// Converts the page's time stamps to world time.
#pragma once

#include <algorithm>

namespace muster {

/// Maps the time stamps of one client. The offset between the clocks is taken from the message that travelled
/// fastest so far. While the world runs, stamps never decrease, never lie in the future and lie at most
/// kOldest in the past. While it is paused, stamps advance with real time, so that they still show which
/// touches came down together.
class TouchClock {
public:
    static constexpr double kOldest = 0.5;  ///< The greatest age of a stamp, in world time [s].

    /// The world time of an event with the page's time stamp `page`, received at real time `real` while the
    /// world is at `now` and runs `speed` times as fast as real time (0: paused) [s].
    double stamp(double page, double real, double now, double speed) {
        const double delay = real - page;
        if (!known_ || delay < offset_) offset_ = delay;
        known_ = true;
        if (!(speed > 0.0)) {
            if (!paused_) pausedPage_ = page;
            paused_ = true;
            return now + std::max(0.0, page - pausedPage_);
        }
        paused_ = false;
        const double age = (delay - offset_) * speed;
        last_ = std::clamp(now - age, std::max(last_, now - kOldest), now);
        return last_;
    }
    /// Restarts at world time 0.
    void restart() {
        last_ = 0.0;
        paused_ = false;
    }

private:
    bool known_ = false;
    bool paused_ = false;
    double pausedPage_ = 0.0;  // Page time of the first event of this pause [s].
    double offset_ = 0.0;      // Real time minus page time [s].
    double last_ = 0.0;        // The last stamp, in world time [s].
};

}  // namespace muster
