#include "lab/reproduce/experiments/lane_watch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace muster {

LaneWatch::LaneWatch(double x, std::vector<double> borders, const World& world)
    : x_(x),
      borders_(std::move(borders)),
      position_(world.characters().position.begin(), world.characters().position.end()),
      lane_(position_.size(), -1),
      time_(position_.size(), 0.0) {}

void LaneWatch::observe(const World& world) {
    crossed_.clear();
    const std::span<const Vec2> now = world.characters().position;
    for (std::size_t i = 0; i < position_.size(); ++i) {
        const Vec2 before = position_[i];
        position_[i] = now[i];
        if (before.x >= x_ || now[i].x < x_) continue;
        const double share = (x_ - before.x) / (now[i].x - before.x);
        lane_[i] = laneAt(lerp(before, now[i], share).y);
        time_[i] = world.time();
        crossed_.push_back(i);
    }
}

std::int32_t LaneWatch::laneAt(double y) const {
    return static_cast<std::int32_t>(std::upper_bound(borders_.begin(), borders_.end(), y) -
                                     borders_.begin());
}

std::int32_t LaneWatch::count(std::int32_t lane) const {
    return static_cast<std::int32_t>(std::count(lane_.begin(), lane_.end(), lane));
}

double LaneWatch::lastCrossing() const {
    if (lane_.empty() || count(-1) > 0) return std::numeric_limits<double>::quiet_NaN();
    return *std::max_element(time_.begin(), time_.end());
}

}  // namespace muster
