// Piecewise linear motion of obstacles and patches.
#include <algorithm>
#include <cmath>
#include <string>

#include "muster/ground.h"

namespace muster {
namespace {

// A time relative to the waypoints.
struct Segment {
    std::ptrdiff_t from = 0;  // Index of the last waypoint before.
    double share = 0.0;       // Share of the time to the next waypoint that has passed.
    bool moving = false;      // False before the first and after the last waypoint.
};

Segment segmentAt(const TimedPath& path, double time) {
    const std::vector<Waypoint>& points = path.waypoints;
    const double first = points.front().time;
    const double last = points.back().time;
    if (path.loop && last > first && time >= first) {
        const double period = last - first;
        const double loops = std::floor((time - first) / period);
        time = std::clamp(time - loops * period, first, std::nextafter(last, first));
    }
    if (points.size() < 2 || time < first) return {};
    if (time >= last) return {std::ssize(points) - 1, 0.0, false};
    const auto after = std::upper_bound(points.begin(), points.end(), time,
                                        [](double t, const Waypoint& w) { return t < w.time; });
    const std::ptrdiff_t from = after - points.begin() - 1;
    return {from, (time - points[from].time) / (points[from + 1].time - points[from].time), true};
}

}  // namespace

Waypoint TimedPath::at(double time) const {
    if (still()) return {time, {}, 0.0};
    const Segment segment = segmentAt(*this, time);
    const Waypoint& a = waypoints[segment.from];
    if (!segment.moving) return {time, a.position, a.angle};
    const Waypoint& b = waypoints[segment.from + 1];
    return {time, lerp(a.position, b.position, segment.share), a.angle + (b.angle - a.angle) * segment.share};
}

Vec2 TimedPath::velocity(double time) const {
    if (still()) return {};
    const Segment segment = segmentAt(*this, time);
    if (!segment.moving) return {};
    const Waypoint& a = waypoints[segment.from];
    const Waypoint& b = waypoints[segment.from + 1];
    return (b.position - a.position) / (b.time - a.time);
}

double TimedPath::angularVelocity(double time) const {
    if (still()) return 0.0;
    const Segment segment = segmentAt(*this, time);
    if (!segment.moving) return 0.0;
    const Waypoint& a = waypoints[segment.from];
    const Waypoint& b = waypoints[segment.from + 1];
    return (b.angle - a.angle) / (b.time - a.time);
}

Status TimedPath::validate() const {
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
        const Waypoint& w = waypoints[i];
        const std::string name = "waypoint " + std::to_string(i);
        const bool sane = isFinite(w.position) && std::fabs(w.time) <= 1e7 && std::fabs(w.angle) <= 1e5 &&
                          std::fabs(w.position.x) <= 1e7 && std::fabs(w.position.y) <= 1e7;
        if (!sane) return invalidArgument(name + " holds a number that is not finite or too large");
        if (i > 0 && w.time - waypoints[i - 1].time < 1e-6) {
            return invalidArgument(name + " is not later than the one before");
        }
    }
    return {};
}

}  // namespace muster
