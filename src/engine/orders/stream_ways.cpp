#include "engine/orders/stream_ways.h"

#include <limits>

namespace muster {
namespace {

constexpr double kLook = 0.5;  // Distance between looks at the ground along a route [m].

}  // namespace

void StreamWays::start(const StreamDef& def) {
    other_ = !def.drawn && def.poses.empty() && def.way.size() > 2;
    points_.assign(def.way.begin(), def.way.end());
    way_ = 0.0;
    best_ = 0;
    StreamDef on = def, round = def;
    on.measured = round.measured = other_;
    const std::array<Vec2, 2> straight{def.way.front(), def.way.back()};
    if (other_) on.way = straight;
    plans_[0].start(on);
    round.drawn = true;
    plans_[1].start(round);
    status_ = plans_[0].status();
}

StreamStatus StreamWays::advance(StreamGround ground, std::int64_t operations) {
    const std::int64_t until = this->operations() + operations;
    if (other_ && way_ == 0.0) measureWay(ground);
    while (status_ == StreamStatus::Planning && this->operations() < until) {
        if (plans_[best_].advance(ground, until - this->operations()) != StreamStatus::Planning) compare();
    }
    return status_;
}

void StreamWays::measureWay(StreamGround ground) {
    for (std::size_t k = 1; k < points_.size(); ++k) {
        const Vec2 a = points_[k - 1], b = points_[k];
        const double part = distance(a, b);
        const auto looks = ground.uneven() ? static_cast<std::int32_t>(part / kLook) + 1 : 1;
        for (std::int32_t j = 0; j < looks; ++j)
            way_ += part / looks / ground.speed(lerp(a, b, (j + 0.5) / looks));
    }
}

void StreamWays::compare() {
    const Stream &on = plans_[0], &round = plans_[1];
    if (best_ == 0 && other_ && (on.status() == StreamStatus::Blocked || on.length() > way_)) {
        best_ = 1;
        return;
    }
    if (best_ == 1 && on.status() != StreamStatus::Blocked &&
        (round.status() == StreamStatus::Blocked || on.length() <= round.length()))
        best_ = 0;
    status_ = plans_[best_].status();
}

}  // namespace muster
