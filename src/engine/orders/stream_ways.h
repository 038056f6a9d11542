// A march that flows along the better of two routes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream.h"

namespace muster {

/// Plans a march straight on, where the stream divides round obstacles, and along its route, where it goes
/// round together; the group marches on the one that arrives first. The route is not tried where it could not
/// be quicker. Owns its memory and reuses it.
class StreamWays {
public:
    /// Begins a plan from a copy of the definition. A drawn route is the only one.
    void start(const StreamDef& def);
    /// Goes on for about `operations` operations.
    StreamStatus advance(StreamGround ground, std::int64_t operations);

    StreamStatus status() const { return status_; }  ///< Status of the plan.
    /// Operations since the start.
    std::int64_t operations() const { return plans_[0].operations() + plans_[1].operations(); }
    std::size_t places() const { return plans_[0].places(); }  ///< Number of places.
    /// The march that arrives first. Only once planned.
    Stream& best() { return plans_[best_]; }

private:
    void compare();
    void measureWay(StreamGround ground);

    std::array<Stream, 2> plans_;  // Plans straight on, and along the route.
    std::size_t best_ = 0;
    bool other_ = false;        // True if there is another route than straight on.
    std::vector<Vec2> points_;  // Points of that route [m].
    double way_ = 0.0;          // Length of that route in metres of good ground.
    StreamStatus status_ = StreamStatus::Blocked;
};

}  // namespace muster
