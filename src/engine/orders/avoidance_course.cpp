// Courses of manoeuvres, and whom they meet.
#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "base/maths.h"
#include "engine/orders/avoidance.h"

namespace muster {
namespace {

constexpr double kTurnTime = 2.0;     // Within which it has turned to its way [s].
constexpr double kAskew = 0.05;       // It faces along its way within this angle [rad].
constexpr double kMostTurn = 1.0;     // Larger turns are as wide [rad].
constexpr double kCertain = 2.5;      // So long a mesh keeps its velocity, whatever the other does [s].
constexpr double kCertainStop = 3.5;  // The same where this one stops.

/// Adds parts one after the other.
class CourseBuilder {
public:
    explicit CourseBuilder(const AvoidanceQuery& query)
        : query_(query),
          at_(query.middle),
          offset_(
              Rotation{query.own.axis.x, query.own.axis.y}.applyInverse(query.own.centre - query.middle)) {}

    /// Goes at one velocity until a time, at most to the horizon.
    void go(Vec2 velocity, double until, Vec2 axis, double grown) {
        const double end = std::min(until, kMoverHorizon);
        if (end <= now_ || course.count == Course::kMost) return;
        MovingBox part = query_.own;
        part.axis = axis;
        part.velocity = velocity;
        part.from = now_;
        part.to = end;
        part.centre = at_ + Rotation{axis.x, axis.y}.apply(offset_) - velocity * now_;
        // As wide as it is while it turns so far.
        const double c = cosine(grown), s = sine(grown);
        part.half = {part.half.x * c + part.half.y * s, part.half.y * c + part.half.x * s};
        course.parts[course.count++] = part;
        at_ += velocity * (end - now_);
        now_ = end;
    }
    /// From one velocity to another.
    void change(Vec2 from, Vec2 to, Vec2 axis, double grown) {
        const double half = 0.5 * distance(from, to) / query_.acceleration;
        go(lerp(from, to, 0.25), now_ + half, axis, grown);
        go(lerp(from, to, 0.75), now_ + half, axis, grown);
    }
    Vec2 at() const { return at_; }
    double now() const { return now_; }

    Course course;

private:
    const AvoidanceQuery& query_;
    Vec2 at_;
    Vec2 offset_;  // Of the box, in its axes.
    double now_ = 0.0;
};

/// The way ahead, which is gone leg by leg.
class WayAhead {
public:
    explicit WayAhead(const AvoidanceQuery& query) : query_(query), axis_(query.own.axis) {}

    /// Goes on along the way at a speed until a time [s], or the end.
    void follow(CourseBuilder& builder, double speed, double until, double grown) {
        const std::size_t most = Course::kMost - 3;
        until = std::min(until, kMoverHorizon);
        while (next_ < query_.ahead.size() && builder.now() < until && builder.course.count < most) {
            const Vec2 leg = query_.ahead[next_] - builder.at();
            const double part = length(leg);
            if (part < 1e-6) {
                ++next_;
                continue;
            }
            const Vec2 along = leg / part;
            const bool turned = query_.wheels && (next_ > 0 || builder.now() >= kTurnTime);
            if (turned) axis_ = dot(axis_, along) < 0.0 ? -along : along;
            double end = builder.now() + part / speed;
            const bool whole = end <= until;
            end = std::min(end, until);
            // It turns to its way at first.
            if (!turned && grown > 0.0) end = std::min(end, kTurnTime);
            builder.go(along * speed, end, axis_, turned ? 0.0 : grown);
            if (whole && (turned || grown <= 0.0 || end < kTurnTime)) ++next_;
        }
    }
    /// Direction of the leg from a point, of unit length.
    Vec2 along(Vec2 from) const {
        return next_ < query_.ahead.size() ? normalized(query_.ahead[next_] - from, axis_) : Vec2{};
    }
    Vec2 axis() const { return axis_; }

private:
    const AvoidanceQuery& query_;
    Vec2 axis_;
    std::size_t next_ = 0;
};

}  // namespace

double arrivalOf(const AvoidanceQuery& query, const Manoeuvre& manoeuvre) {
    Vec2 at = query.middle;
    const Vec2 way = normalized(query.ahead.front() - at, query.own.axis);
    const Vec2 velocity = rotationBy(manoeuvre.angle).apply(way) * manoeuvre.speed;
    const double ramp = distance(query.own.velocity, velocity) / query.acceleration;
    double seconds = ramp + manoeuvre.seconds;
    double gone = 0.0;
    if (manoeuvre.angle == 0.0)
        gone = dot(way, query.own.velocity + velocity) * 0.5 * ramp + manoeuvre.speed * manoeuvre.seconds;
    else
        at += (query.own.velocity + velocity) * (0.5 * ramp) + velocity * manoeuvre.seconds;
    double left = -gone;
    for (const Vec2 corner : query.ahead) {
        left += distance(at, corner);
        at = corner;
    }
    // The change back takes half of its time more.
    seconds += 0.5 * distance(velocity, way * query.cruise) / query.acceleration;
    return seconds + left / query.cruise;
}

Course courseOf(const AvoidanceQuery& query, const Manoeuvre& manoeuvre) {
    CourseBuilder builder(query);
    WayAhead ahead(query);
    const Vec2 way = ahead.along(query.middle);
    const Vec2 axis = query.own.axis;
    Vec2 velocity = rotationBy(manoeuvre.angle).apply(way) * manoeuvre.speed;
    const double askew = std::fabs(cross(axis, way));
    double grown = 0.0;
    if (query.wheels && askew > kAskew)
        grown = std::min(kMostTurn, arcTangent2(askew, std::fabs(dot(axis, way))));
    builder.change(query.own.velocity, velocity, axis, grown);
    const double end = builder.now() + manoeuvre.seconds;
    if (manoeuvre.stops || manoeuvre.angle != 0.0 || manoeuvre.speed <= 0.0)
        builder.go(velocity, end, axis, grown);
    else
        ahead.follow(builder, manoeuvre.speed, end, grown);
    if (manoeuvre.stops) {
        builder.change(velocity, {}, axis, grown);
    } else {
        const Vec2 back = ahead.along(builder.at()) * query.cruise;
        if (manoeuvre.angle == 0.0 && manoeuvre.speed > 0.0)
            velocity = ahead.along(builder.at()) * manoeuvre.speed;
        builder.change(velocity, back, ahead.axis(), grown);
        ahead.follow(builder, query.cruise, kMoverHorizon, grown);
    }
    builder.go({}, kMoverHorizon, ahead.axis(), 0.0);
    return builder.course;
}

double firstContact(const AvoidanceQuery& query, const Course& course, bool stops, const Neighbour& neighbour,
                    double margin) {
    const double certain = !neighbour.isMesh  ? kMoverHorizon
                           : neighbour.shares ? (stops ? kCertainStop : kCertain)
                                              : kMeshHorizon;
    for (std::size_t k = 0; k < course.count; ++k) {
        const MovingBox& part = course.parts[k];
        if (part.from > certain && (stops || !neighbour.shares)) break;
        const TimeSpan span = contactSpan(part, neighbour.box, margin);
        if (!span.empty() && span.from <= certain) return span.from;
        if (stops || !neighbour.shares || part.from > kMeshHorizon) continue;
        // It changes its velocity by as much as this one does, the other way.
        MovingBox other = neighbour.box;
        const Vec2 offset = Rotation{part.axis.x, part.axis.y}.apply(
            Rotation{query.own.axis.x, query.own.axis.y}.applyInverse(query.own.centre - query.middle));
        other.centre -= part.centre - offset - query.middle;
        other.velocity -= part.velocity - query.own.velocity;
        const TimeSpan shared = contactSpan(part, other, margin);
        if (!shared.empty() && shared.from <= kMeshHorizon) return shared.from;
    }
    return kInfiniteCost;
}

}  // namespace muster
