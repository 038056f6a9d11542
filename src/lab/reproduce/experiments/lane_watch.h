// Records the lane of each character, and the time of its crossing.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"

namespace muster {

/// Observes the line x = const, which borders divide into lanes: lane 0 lies below the first border, lane 1
/// above it, and so on. A crossing goes from left to right; if a character crosses several times the last
/// crossing counts. The number of characters must not change.
class LaneWatch {
public:
    /// The line [m], and its borders in rising order [m]; call before the first step.
    LaneWatch(double x, std::vector<double> borders, const World& world);
    /// Call after every step.
    void observe(const World& world);

    /// The lane that a point of this y [m] lies in; a point on a border is in the lane above it.
    std::int32_t laneAt(double y) const;
    /// Lane of each character; -1 for a character that has not crossed.
    const std::vector<std::int32_t>& lanes() const { return lane_; }
    /// Indices of characters that crossed in the last step, ascending.
    const std::vector<std::size_t>& crossedNow() const { return crossed_; }
    /// Number of characters that took the lane.
    std::int32_t count(std::int32_t lane) const;
    /// Time at which the last character crossed [s]; NaN until all have.
    double lastCrossing() const;

private:
    double x_;
    std::vector<double> borders_;
    std::vector<Vec2> position_;
    std::vector<std::int32_t> lane_;
    std::vector<double> time_;
    std::vector<std::size_t> crossed_;
};

}  // namespace muster
