// From the page's clock to the world's.
#pragma once

#include <algorithm>

namespace muster {

/// Maps one client's time stamps. The offset between the clocks is that of the message that travelled fastest
/// so far; while the world runs stamps never fall, never lie in the future and at most kOldest in the past.
/// While it is paused they run on with real time, so that they still tell which touches came down together.
class TouchClock {
public:
    static constexpr double kOldest = 0.5;  ///< [s] of world time.

    /// The world time of an event with the stamp `page`, received at `real` while the world stands at `now`
    /// and runs `speed` times as fast as real time (0: paused) [s].
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
    /// The world began anew, at time 0.
    void restart() {
        last_ = 0.0;
        paused_ = false;
    }

private:
    bool known_ = false;
    bool paused_ = false;
    double pausedPage_ = 0.0;  // Stamp of the first event of this pause [s].
    double offset_ = 0.0;      // Real minus page [s].
    double last_ = 0.0;        // Of the world [s].
};

}  // namespace muster
