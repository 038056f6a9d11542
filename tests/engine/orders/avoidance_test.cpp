// Courses of formations: what meets whom is reckoned by closed forms here, and by small steps of time.
#include "engine/orders/avoidance.h"

#include <doctest.h>

#include <cmath>

#include "base/maths.h"
#include "base/random.h"

using namespace muster;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

MovingBox disc(Vec2 centre, double radius, Vec2 velocity) {
    return {.centre = centre, .round = radius, .velocity = velocity};
}

/// Corners at a time.
std::array<Vec2, 4> cornersOf(const MovingBox& box, double time) {
    const Vec2 centre = box.centre + box.velocity * time;
    const Vec2 a = box.axis * box.half.x, b = perpendicular(box.axis) * box.half.y;
    return {centre + a + b, centre - a + b, centre - a - b, centre + a - b};
}

/// True where two boxes overlap at a time: a corner in the other, or edges that cross.
bool overlap(const MovingBox& a, const MovingBox& b, double time) {
    const auto p = cornersOf(a, time), q = cornersOf(b, time);
    const auto contains = [](const std::array<Vec2, 4>& box, Vec2 point) {
        for (int i = 0; i < 4; ++i)
            if (cross(box[(i + 1) % 4] - box[i], point - box[i]) < 0.0) return false;
        return true;
    };
    for (int i = 0; i < 4; ++i)
        if (contains(p, q[i]) || contains(q, p[i])) return true;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const Vec2 a0 = p[i], a1 = p[(i + 1) % 4], b0 = q[j], b1 = q[(j + 1) % 4];
            if (cross(a1 - a0, b0 - a0) * cross(a1 - a0, b1 - a0) < 0.0 &&
                cross(b1 - b0, a0 - b0) * cross(b1 - b0, a1 - b0) < 0.0)
                return true;
        }
    return false;
}

/// A square formation with a straight way along +x.
CourseDef formation(double speed) {
    static const std::array<Vec2, 1> kEnd{Vec2{100, 0}};
    return {.box = {.half = {2, 2}},
            .ahead = kEnd,
            .side = {0, 1},
            .speed = speed,
            .cruise = 2.0,
            .acceleration = 4.0};
}

/// Where a course is at a time.
Vec2 placeAt(const Course& course, double time) {
    for (const MovingBox& part : course)
        if (time <= part.to) return part.centre + part.velocity * time;
    return course.back().centre;
}

}  // namespace

TEST_CASE("discs meet when the quadratic equation says so") {
    Random random(5);
    for (int k = 0; k < 500; ++k) {
        const auto any = [&](double most) {
            return Vec2{random.uniform(-most, most), random.uniform(-most, most)};
        };
        const MovingBox a = disc(any(10), random.uniform(0.1, 2), any(3));
        const MovingBox b = disc(any(10), random.uniform(0.1, 2), any(3));
        const TimeSpan span = contactSpan(a, b);
        // The closest approach of two points.
        const Vec2 offset = b.centre - a.centre, velocity = b.velocity - a.velocity;
        const double when = std::max(0.0, -dot(offset, velocity) / lengthSquared(velocity));
        const double nearest = length(offset + velocity * when);
        CHECK(span.empty() == (nearest > a.round + b.round));
        if (span.empty() || span.from <= 0.0) continue;
        CHECK(length(offset + velocity * span.from) == doctest::Approx(a.round + b.round));
        CHECK(dot(offset + velocity * span.from, velocity) < 0.0);
    }
}

TEST_CASE("boxes meet when a look at every hundredth of a second says so") {
    Random random(6);
    int met = 0;
    for (int k = 0; k < 300; ++k) {
        const auto box = [&] {
            MovingBox made = disc({random.uniform(-8, 8), random.uniform(-8, 8)}, 0.0,
                                  {random.uniform(-3, 3), random.uniform(-3, 3)});
            const double angle = random.uniform(-3, 3);
            made.axis = {cosine(angle), sine(angle)};
            made.half = {random.uniform(0.2, 4), random.uniform(0.2, 2)};
            made.to = 6.0;
            return made;
        };
        const MovingBox a = box(), b = box();
        const TimeSpan span = contactSpan(a, b);
        double first = kNever, last = -1.0;
        for (int i = 0; i <= 600; ++i)
            if (overlap(a, b, 0.01 * i)) {
                first = std::min(first, 0.01 * i);
                last = 0.01 * i;
            }
        if (first == kNever) {
            CHECK((span.empty() || span.to - span.from < 0.011));
            continue;
        }
        ++met;
        REQUIRE_FALSE(span.empty());
        CHECK(span.from <= first + 1e-9);
        CHECK(span.from >= first - 0.0101);
        CHECK(span.to >= last - 1e-9);
        CHECK(span.to <= last + 0.0101);
    }
    CHECK(met > 60);
}

TEST_CASE("a course goes on without a jump, waits as long as it should and comes aside as far") {
    for (const double speed : {0.0, 2.0})
        for (const double wait : {0.0, 3.0})
            for (const double offCourse : {0.0, -4.0, 2.5}) {
                Course course;
                listCourse(formation(speed), {wait, offCourse}, kCourseHorizon, course);
                REQUIRE(!course.empty());
                CHECK(course.front().from == 0.0);
                CHECK(course.back().to == kCourseHorizon);
                for (std::size_t k = 1; k < course.size(); ++k) {
                    CHECK(course[k].from == course[k - 1].to);
                    CHECK(distance(course[k].centre + course[k].velocity * course[k].from,
                                   course[k - 1].centre + course[k - 1].velocity * course[k].from) < 1e-9);
                }
                const Vec2 end = placeAt(course, kCourseHorizon);
                CHECK(end.y == doctest::Approx(offCourse));
                // Aside it is slower on its way; a start takes half a ramp.
                const double slow = std::fabs(offCourse) / (kSideShare * 2.0) * (1.0 - kOnwardShare);
                const double walked = 2.0 * (kCourseHorizon - wait - slow);
                CHECK(end.x > walked - 1.1);
                CHECK(end.x < walked + 1.1);
            }
}

TEST_CASE("who waits lets pass") {
    MovingBox car{.centre = {10, -20}, .axis = {0, 1}, .half = {2, 1}, .velocity = {0, 5}};
    Course course;
    listCourse(formation(2.0), {}, kCourseHorizon, course);
    CHECK(firstContact(course, {&car, 1}, 0.5) == doctest::Approx((10.0 - 2.0 - 1.0 - 0.5) / 2.0));
    listCourse(formation(2.0), {3.0, 0.0}, kCourseHorizon, course);
    CHECK(firstContact(course, {&car, 1}, 0.5) == kNever);
}
