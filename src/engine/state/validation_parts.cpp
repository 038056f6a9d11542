#include "engine/state/validation_parts.h"

#include <cmath>

#include "engine/state/validation.h"

namespace muster {

Status inRange(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return {};
    return invalidArgument(std::string(what) + " is " + numberText(value) + ", expected a number in [" +
                           numberText(low) + ", " + numberText(high) + "]");
}

Status isOwn(const char* what, double value, double low, double high) {
    return value == 0.0 ? Status() : inRange(what, value, low, high);
}

Status isPlace(const char* what, Vec2 p) {
    if (std::fabs(p.x) <= kMaxCoordinate && std::fabs(p.y) <= kMaxCoordinate) return {};
    return invalidArgument(std::string(what) + " (" + numberText(p.x) + ", " + numberText(p.y) +
                           ") is not finite or farther than 1e6 m from the origin");
}

Status arePlaces(const char* what, std::span<const Vec2> points) {
    if (points.size() > static_cast<std::size_t>(kMaxCharacters)) {
        return {StatusCode::LimitExceeded, std::string(what) + " has " + std::to_string(points.size()) +
                                               " points, at most " + std::to_string(kMaxCharacters) +
                                               " are allowed"};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (Status s = isPlace(what, points[i]); !s.ok()) return s.within("point " + std::to_string(i));
    }
    return {};
}

Status isPath(const TimedPath& path) {
    if (path.waypoints.size() > kMaxCorners)
        return {StatusCode::LimitExceeded, "path has too many waypoints"};
    for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
        const Waypoint& w = path.waypoints[i];
        const std::string where = "waypoint " + std::to_string(i);
        if (Status s = isPlace("position", w.position); !s.ok()) return s.within(where);
        if (Status s = inRange("time", w.time, 0.0, 1e9); !s.ok()) return s.within(where);
        if (Status s = inRange("angle", w.angle, -1e6, 1e6); !s.ok()) return s.within(where);
    }
    return path.validate();
}

Status first(std::initializer_list<Status> checks) {
    for (const Status& s : checks) {
        if (!s.ok()) return s;
    }
    return {};
}

}  // namespace muster
