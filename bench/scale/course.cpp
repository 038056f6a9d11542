#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "scale/crowd_scenes.h"

namespace muster::scale {
namespace {

double lengthOf(const Course& course) {
    double sum = 0.0;
    for (std::size_t k = 1; k < course.points.size(); ++k)
        sum += distance(course.points[k - 1], course.points[k]);
    return sum;
}

// The point at arc length `along` within the polyline, and its direction there.
void pointAt(const Course& course, double along, Vec2& point, Vec2& direction) {
    for (std::size_t k = 1; k < course.points.size(); ++k) {
        const Vec2 a = course.points[k - 1];
        const Vec2 b = course.points[k];
        const double step = distance(a, b);
        direction = normalized(b - a, direction);
        if (along <= step || k + 1 == course.points.size()) {
            point = lerp(a, b, step > 0.0 ? std::min(1.0, along / step) : 0.0);
            return;
        }
        along -= step;
    }
}

// A triangular wave of slope 1 between 0 and `half`.
double toAndFro(double value, double half) {
    const double whole = 2.0 * half;
    const double rest = value - whole * std::floor(value / whole);
    return rest <= half ? rest : whole - rest;
}

}  // namespace

CoursePose poseAt(const Course& course, double time) {
    const double whole = lengthOf(course);
    double travelled = course.speed * time;
    if (course.reverseEvery > 0.0) travelled = toAndFro(travelled, course.speed * course.reverseEvery);
    double along = course.begin + travelled;
    along = course.closed ? along - whole * std::floor(along / whole) : toAndFro(along, whole);
    CoursePose pose;
    Vec2 direction{1.0, 0.0};
    pointAt(course, along, pose.position, direction);
    // A closed course is a circle round the origin, walked counter-clockwise from below.
    if (course.closed) pose.angle = 2.0 * kPi * (course.begin + travelled) / whole;
    pose.angle += course.turn * sine(2.0 * kPi * time / course.turnPeriod);
    return pose;
}

}  // namespace muster::scale
