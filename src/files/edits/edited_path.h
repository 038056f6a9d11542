// The path of edited people: their own clock, and how far pins move them (docs/method/take-edits.md).
#pragma once

#include <span>
#include <vector>

#include "muster/take.h"

namespace muster {

/// 1 at the moment of a pin, 0 at the end of its reach; twice continuously differentiable, and with its
/// mirror image it adds up to 1.
double pinWeight(double share);
/// Its derivative by the share.
double pinWeightSlope(double share);

/// A time on an own clock and how fast that runs.
struct OwnTime {
    double time = 0.0;  ///< Time of the recording [s].
    double rate = 1.0;  ///< Seconds of the recording per second, 0 or more.
};

/// The clock of edited people: monotone cubic pieces through its points (Fritsch and Carlson 1980), and as
/// usual before and after them.
class OwnClock {
public:
    /// The points must pass checkEdits().
    explicit OwnClock(std::vector<ClockPoint> points);
    OwnTime at(double time) const;  ///< At a time of the take [s].
    /// The earliest time of the take at which it shows that time of the recording [s].
    double when(double own) const;
    bool usual() const { return points_.empty(); }  ///< True where it runs as the take.

private:
    std::vector<ClockPoint> points_;
    std::vector<double> slopes_;  ///< By point.
};

/// How far somebody is moved, and how fast that changes by the own clock.
struct PinMove {
    Vec2 offset;    ///< [m]
    Vec2 velocity;  ///< [m/s]
};

/// Where pins move a path at that time of the own clock [s]. A pin reaches to its seconds or to the next pin,
/// whichever is nearer, so that each is met exactly. They must pass checkEdits().
PinMove pinMove(std::span<const PathPin> pins, double own);

}  // namespace muster
