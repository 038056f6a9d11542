// A limit of the rate of messages or other events.
#pragma once

#include <algorithm>

namespace muster {

/// Lets through `rate` tokens a second on average, and `burst` at once. Time is given, never read.
class TokenBucket {
public:
    /// A bucket that is full at first. `rate` [1/s] > 0, `burst` >= 1.
    TokenBucket(double rate, double burst) : rate_(rate), burst_(burst), tokens_(burst) {}

    /// Takes `tokens` at time `now` [s, never falling]; false, taking none, where there are fewer.
    bool take(double now, double tokens = 1.0) {
        tokens_ = std::min(burst_, tokens_ + (now - last_) * rate_);
        last_ = now;
        if (tokens_ < tokens) return false;
        tokens_ -= tokens;
        return true;
    }

private:
    double rate_;
    double burst_;
    double tokens_;
    double last_ = 0.0;
};

}  // namespace muster
