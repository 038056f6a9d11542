#include "engine/orders/avoidance.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"

namespace muster {
namespace {

/// Lists the parts of a course one after the other.
class CourseList {
public:
    CourseList(const CourseDef& def, double until, Course& course)
        : def_(def),
          until_(until),
          course_(course),
          on_(def.middle - def.side * def.offCourse),
          beside_(def.offCourse) {
        course_.clear();
    }
    /// Goes on at a velocity along the route and a speed to the left [m/s], until a time [s].
    void go(Vec2 velocity, double sideways, double end) {
        end = std::min(end, until_);
        if (end <= now_) return;
        MovingBox part = def_.box;
        part.velocity = velocity + def_.side * sideways;
        part.from = now_;
        part.to = end;
        part.centre += on_ + def_.side * beside_ - def_.middle - part.velocity * now_;
        course_.push_back(part);
        on_ += velocity * (end - now_);
        beside_ += sideways * (end - now_);
        now_ = end;
    }
    /// Waits, and starts again. During a change of speed half of the time counts at each speed.
    void wait(double seconds) {
        const Vec2 along = normalized(def_.ahead.front() - on_);
        const double half = 0.5 / def_.acceleration, speed = seconds > 0.0 ? 0.0 : def_.speed;
        if (seconds > 0.0) go(along * def_.speed, 0.0, half * def_.speed);
        go(along * speed, 0.0, seconds + half * std::max(0.0, def_.cruise - speed));
    }
    /// Goes to a corner; sideways until `shifted` [s].
    void follow(Vec2 corner, double sideways, double shifted) {
        if (now_ < shifted) {
            const Vec2 along = normalized(corner - on_) * (kOnwardShare * def_.cruise);
            go(along, sideways,
               std::min(shifted, now_ + distance(on_, corner) / (kOnwardShare * def_.cruise)));
        }
        if (now_ < shifted) return;
        const Vec2 along = normalized(corner - on_) * def_.cruise;
        go(along, 0.0, now_ + distance(on_, corner) / def_.cruise);
    }
    double now() const { return now_; }

private:
    const CourseDef& def_;
    double until_;
    Course& course_;
    Vec2 on_;  // Point on the route.
    double beside_;
    double now_ = 0.0;
};

}  // namespace

void listCourse(const CourseDef& def, const Manoeuvre& manoeuvre, double until, Course& course) {
    CourseList list(def, until, course);
    list.wait(manoeuvre.wait);
    const double off = manoeuvre.offCourse - def.offCourse;
    const double sideways = off < 0.0 ? -kSideShare * def.cruise : kSideShare * def.cruise;
    const double shifted = list.now() + off / sideways;
    for (const Vec2 corner : def.ahead) list.follow(corner, sideways, shifted);
    list.go({}, 0.0, until);
}

double firstContact(std::span<const MovingBox> course, std::span<const MovingBox> other, double margin) {
    for (const MovingBox& part : course) {
        double first = kInfiniteCost;
        for (const MovingBox& box : other) {
            const TimeSpan span = contactSpan(part, box, margin);
            if (!span.empty()) first = std::min(first, span.from);
        }
        if (first < kInfiniteCost) return first;
    }
    return kInfiniteCost;
}

double timeLost(const CourseDef& def, const Manoeuvre& manoeuvre) {
    // The formation goes aside, and back.
    const double offCourse = std::fabs(manoeuvre.offCourse - def.offCourse) + std::fabs(manoeuvre.offCourse);
    return manoeuvre.wait + offCourse * (1.0 - kOnwardShare) / (kSideShare * def.cruise);
}

}  // namespace muster
