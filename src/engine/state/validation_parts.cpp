#include "engine/state/validation_parts.h"

#include <cmath>

#include "engine/geometry/polygon.h"
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

Status isOwnOrNegative(const char* what, double value, double low, double high) {
    return value < 0.0 ? Status() : inRange(what, value, low, high);
}

bool isInWorld(Vec2 p) {
    return std::fabs(p.x) <= kMaxCoordinate && std::fabs(p.y) <= kMaxCoordinate;
}

Status isPlace(const char* what, Vec2 p) {
    if (isInWorld(p)) return {};
    return invalidArgument(std::string(what) + " (" + numberText(p.x) + ", " + numberText(p.y) +
                           ") is not finite or farther than 1e6 m from the origin");
}

Status arePlaces(const char* what, std::span<const Vec2> points, std::size_t most) {
    if (points.size() > most)
        return {StatusCode::LimitExceeded, std::string(what) + " has " + std::to_string(points.size()) +
                                               " points, at most " + std::to_string(most) + " are allowed"};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (Status s = isPlace(what, points[i]); !s.ok()) return s.within("point " + std::to_string(i));
    }
    return {};
}

Status isShape(const char* what, std::span<const Vec2> corners) {
    if (corners.size() > kMaxCorners) {
        return {StatusCode::LimitExceeded, std::string(what) + " has " + std::to_string(corners.size()) +
                                               " corners, at most " + std::to_string(kMaxCorners) +
                                               " are allowed"};
    }
    if (Status s = arePlaces(what, corners, kMaxCorners); !s.ok()) return s;
    const auto clean = cleanPolygon(corners);
    return clean.ok() ? Status() : clean.status().within(what);
}

Status isShapeOrNone(const char* what, std::span<const Vec2> corners) {
    return corners.empty() ? Status() : isShape(what, corners);
}

Status isText(const char* what, const std::string& value) {
    if (value.size() <= kMaxText) return {};
    return {StatusCode::LimitExceeded, std::string(what) + " has " + std::to_string(value.size()) +
                                           " bytes, at most " + std::to_string(kMaxText) + " are allowed"};
}

Status isPath(const TimedPath& path) {
    if (path.waypoints.size() > kMaxCorners)
        return {StatusCode::LimitExceeded, "path has too many waypoints"};
    for (std::size_t i = 0; i < path.waypoints.size(); ++i)
        if (Status s = validate(path.waypoints[i]); !s.ok()) return s.within("waypoint " + std::to_string(i));
    return path.validate();
}

Status atMost(const char* what, std::size_t count, std::size_t most) {
    if (count <= most) return {};
    return {StatusCode::LimitExceeded, std::string(what) + ": found " + std::to_string(count) + ", at most " +
                                           std::to_string(most) + " are allowed"};
}

Status eachInRange(const char* what, std::span<const double> values, std::size_t most, double low,
                   double high) {
    if (Status s = atMost(what, values.size(), most); !s.ok()) return s;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string name = std::string(what) + "[" + std::to_string(i) + "]";
        if (Status s = inRange(name.c_str(), values[i], low, high); !s.ok()) return s;
    }
    return {};
}

Status first(std::initializer_list<Status> checks) {
    for (const Status& s : checks) {
        if (!s.ok()) return s;
    }
    return {};
}

}  // namespace muster
