// A march that flows along the better of two ways.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream.h"

namespace muster {

/// Plans a march straight on, where the stream parts round what stands between, and along its way, where it
/// goes round together; the one that arrives first is marched. The way is not tried where nobody could arrive
/// earlier on it. Owns its memory and uses it again.
class StreamWays {
public:
    /// Begins a plan; what the definition refers to is copied. A drawn way is the only one.
    void start(const StreamDef& def);
    /// Goes on for about so many operations.
    StreamStatus advance(StreamGround ground, std::int64_t operations);

    StreamStatus status() const { return status_; }  ///< Of the plan.
    std::int64_t operations() const {
        return plans_[0].operations() + plans_[1].operations();
    }                                                          ///< Since the start.
    std::size_t places() const { return plans_[0].places(); }  ///< Number of places.
    /// The march that arrives first. Only once planned.
    Stream& best() { return plans_[best_]; }

private:
    void compare();
    void measureWay(StreamGround ground);

    std::array<Stream, 2> plans_;  // Straight on, and along the way.
    std::size_t best_ = 0;
    bool other_ = false;        // True where there is another way than straight on.
    std::vector<Vec2> points_;  // Of it [m].
    double way_ = 0.0;          // Its length in metres of good ground.
    StreamStatus status_ = StreamStatus::Blocked;
};

}  // namespace muster
