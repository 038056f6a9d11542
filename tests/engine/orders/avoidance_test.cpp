// Choices of velocities: what meets whom is reckoned by closed forms here, and by small steps of time.
#include "engine/orders/avoidance.h"

#include <doctest.h>

#include <cmath>
#include <functional>

#include "base/maths.h"
#include "base/random.h"

using namespace muster;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

MovingBox disc(Vec2 centre, double radius, Vec2 velocity) {
    MovingBox box;
    box.centre = centre;
    box.round = radius;
    box.velocity = velocity;
    return box;
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

/// A mesh in the open with a straight way, and all it needs to go there.
struct Walker {
    Vec2 at, goal;
    Vec2 velocity;
    double radius = 2.0;
    Vec2 half;  // A box instead, its length along its way.
    bool avoids = true;
    AvoidanceChoice choice{};
    Avoider avoider{};

    Vec2 way() const { return normalized(goal - at, {1.0, 0.0}); }
    MovingBox box() const {
        MovingBox box = disc(at, half == Vec2{} ? radius : 0.0, velocity);
        box.half = half;
        box.axis = way();
        return box;
    }
    Vec2 wanted() const {
        const double angle = choice.manoeuvre.angle;
        return Rotation{cosine(angle), sine(angle)}.apply(way()) * choice.manoeuvre.speed;
    }
    void choose(std::span<const Neighbour> neighbours) {
        AvoidanceQuery query;
        query.own = box();
        query.middle = at;
        query.ahead = {&goal, 1};
        query.wheels = false;
        query.cruise = query.top = 2.0;
        query.preferred = std::min(2.0, std::sqrt(8.0 * distance(at, goal)));
        query.last = choice.manoeuvre;
        query.last.seconds = std::max(0.0, query.last.seconds - 0.1);
        query.hindered = choice.hindered;
        const auto hasRoom = [](Vec2) { return true; };
        choice = avoider.choose(query, neighbours, std::cref(hasRoom));
    }
    void move(double dt) {
        velocity += clampLength(wanted() - velocity, 4.0 * dt);
        at += velocity * dt;
    }
};

struct Outcome {
    double nearest = kNever;  // Distance between two surfaces of discs [m].
    double seconds = kNever;  // Until all have arrived.
    bool met = false;         // Boxes have overlapped.
};

/// All choose every tenth of a second.
Outcome play(std::vector<Walker>& walkers, double most = 120.0) {
    Outcome outcome;
    constexpr double dt = 1.0 / 60.0;
    std::vector<Neighbour> others;
    for (int step = 0; step * dt < most; ++step) {
        for (std::size_t i = 0; i < walkers.size() && step % 6 == 0; ++i) {
            Walker& walker = walkers[i];
            others.clear();
            for (std::size_t j = 0; j < walkers.size(); ++j)
                if (j != i) others.push_back({walkers[j].box(), 0.5, true, walkers[j].avoids});
            if (!walker.avoids) others.clear();
            walker.choose(others);
        }
        bool all = true;
        for (Walker& walker : walkers) {
            walker.move(dt);
            all = all && distance(walker.at, walker.goal) < 0.3;
        }
        for (std::size_t i = 0; i < walkers.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Walker &a = walkers[i], &b = walkers[j];
                outcome.nearest = std::min(outcome.nearest, distance(a.at, b.at) - a.radius - b.radius);
                if (!(a.half == Vec2{})) outcome.met = outcome.met || overlap(a.box(), b.box(), 0.0);
            }
        if (all) {
            outcome.seconds = step * dt;
            break;
        }
    }
    return outcome;
}

Walker walker(Vec2 at, Vec2 goal, bool avoids = true) {
    Walker made;
    made.at = at;
    made.goal = goal;
    made.avoids = avoids;
    return made;
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

TEST_CASE("alone it goes as it would") {
    Walker one = walker({0, 0}, {20, 0});
    one.choose({});
    CHECK_FALSE(one.choice.hindered);
    CHECK(one.choice.manoeuvre.speed == 2.0);
    CHECK(one.choice.manoeuvre.angle == 0.0);
    // Somebody far to one side changes nothing.
    const Neighbour far{disc({10, 8}, 2.0, {0, 0}), 0.5, true, false};
    one.choose({&far, 1});
    CHECK_FALSE(one.choice.hindered);
}

TEST_CASE("a choice that is free stays clear of a disc at constant velocity, by the closest approach") {
    Random random(7);
    int hindered = 0;
    for (int k = 0; k < 400; ++k) {
        Walker one = walker({0, 0}, {60, 0});
        one.velocity = {random.uniform(0, 2), random.uniform(-0.5, 0.5)};
        const MovingBox other = disc({random.uniform(3, 20), random.uniform(-12, 12)}, random.uniform(0.5, 3),
                                     {random.uniform(-4, 4), random.uniform(-4, 4)});
        if (distance(one.at, other.centre) < one.radius + other.round + 1.0) continue;
        const Neighbour neighbour{other, 0.5, false, false};
        one.choose({&neighbour, 1});
        if (!one.choice.free) continue;
        hindered += one.choice.hindered ? 1 : 0;
        // It changes its velocity evenly, and stops soon where it says so.
        const bool stops = one.choice.manoeuvre.stops;
        const Vec2 chosen = one.wanted();
        const double ramp = distance(chosen, one.velocity) / 4.0;
        double nearest = kNever;
        for (int i = 0; i < 12 * 60; ++i) {
            const Vec2 wanted = stops && i / 60.0 > 0.3 + ramp ? Vec2{} : chosen;
            one.velocity += clampLength(wanted - one.velocity, 4.0 / 60.0);
            one.at += one.velocity / 60.0;
            const Vec2 there = other.centre + other.velocity * ((i + 1) / 60.0);
            nearest = std::min(nearest, distance(one.at, there) - one.radius - other.round);
        }
        CAPTURE(k);
        CHECK(nearest > 0.3);
    }
    CHECK(hindered > 50);
}

TEST_CASE("two head-on pass each other, both to the right, and lose little time") {
    for (const double off : {0.0, 0.5, -0.5, 3.0}) {
        std::vector<Walker> pair{walker({-25, 0}, {25, 0}), walker({25, off}, {-25, off})};
        const Outcome outcome = play(pair);
        CAPTURE(off);
        MESSAGE("head-on, off by " << off << ": gap " << outcome.nearest << " m, " << outcome.seconds
                                   << " s");
        CHECK(outcome.nearest > 0.0);
        CHECK(outcome.seconds < 1.15 * 25.5);
    }
    std::vector<Walker> pair{walker({-10, 0}, {25, 0}), walker({10, 0}, {-25, 0})};
    for (int step = 0; step < 3 * 60; ++step) {
        for (int i = 0; i < 2 && step % 6 == 0; ++i) {
            const Neighbour other{pair[1 - i].box(), 0.5, true, true};
            pair[i].choose({&other, 1});
        }
        for (Walker& w : pair) w.move(1.0 / 60.0);
    }
    CHECK(pair[0].at.y < -0.3);
    CHECK(pair[1].at.y > 0.3);
    CHECK(pair[0].at.y == doctest::Approx(-pair[1].at.y).epsilon(0.5));
}

TEST_CASE("two that cross, or one that overtakes, stay clear and arrive") {
    std::vector<Walker> crossing{walker({-20, 0}, {20, 0}), walker({0, -20}, {0, 20})};
    const Outcome across = play(crossing);
    MESSAGE("crossing: gap " << across.nearest << " m, " << across.seconds << " s");
    CHECK(across.nearest > 0.0);
    CHECK(across.seconds < 1.25 * 20.5);
    // Half as fast ahead on the same way: it takes nothing of the change.
    Walker slow = walker({-14, 0}, {-8, 0}, false);
    slow.goal = {60, 0};
    std::vector<Walker> chase{walker({-25, 0}, {30, 0})};
    double nearest = kNever, seconds = kNever;
    for (int step = 0; step < 60 * 60 && seconds == kNever; ++step) {
        slow.velocity = {0.8, 0};
        const Neighbour ahead{slow.box(), 0.5, true, false};
        if (step % 6 == 0) chase[0].choose({&ahead, 1});
        chase[0].move(1.0 / 60.0);
        slow.at += slow.velocity / 60.0;
        nearest = std::min(nearest, distance(slow.at, chase[0].at) - 4.0);
        if (distance(chase[0].at, chase[0].goal) < 0.3) seconds = step / 60.0;
    }
    MESSAGE("overtaking: gap " << nearest << " m, " << seconds << " s");
    CHECK(nearest > 0.0);
    CHECK(seconds < 1.25 * 28.0);
}

TEST_CASE("who meets one that does not avoid takes all of the change") {
    std::vector<Walker> pair{walker({-25, 0}, {25, 0}), walker({25, 0}, {-25, 0}, false)};
    const Outcome outcome = play(pair);
    CHECK(outcome.nearest > 0.0);
    CHECK(outcome.seconds < 1.25 * 25.5);
    CHECK(std::fabs(pair[1].at.y) < 1e-9);
}

TEST_CASE("four that cross at one point, and boxes at any angle, stay clear and arrive") {
    std::vector<Walker> four{walker({-25, 0}, {25, 0}), walker({0, -25}, {0, 25}), walker({25, 0}, {-25, 0}),
                             walker({0, 25}, {0, -25})};
    const Outcome outcome = play(four);
    MESSAGE("four: gap " << outcome.nearest << " m, " << outcome.seconds << " s");
    CHECK(outcome.nearest > 0.0);
    CHECK(outcome.seconds < 60.0);
    for (int k = 1; k < 12; ++k) {
        const double angle = k * kPi / 6.0;
        const Vec2 way{cosine(angle), sine(angle)};
        std::vector<Walker> pair{walker({-30, 0}, {30, 0}), walker(way * -30.0, way * 30.0)};
        for (Walker& w : pair) w.half = {2.5, 5.0};
        const Outcome boxes = play(pair);
        CAPTURE(k * 30);
        MESSAGE("boxes at " << k * 30 << " degrees: " << boxes.seconds << " s");
        CHECK_FALSE(boxes.met);
        CHECK(boxes.seconds < 60.0);
    }
}

TEST_CASE("before a stream without a gap it waits, and goes in the first that is long enough") {
    // Cars of 4.5 m at 8 m/s, two of which are 60 m apart.
    std::vector<double> cars;
    for (double x = 10.0; x > -200.0; x -= x < -60.0 && x > -80.0 ? 60.0 : 20.0) cars.push_back(x);
    Walker one = walker({0, -12}, {0, 15});
    one.half = {2.5, 5.0};
    bool met = false;
    double seconds = kNever;
    for (int step = 0; step < 60 * 60 && seconds == kNever; ++step) {
        std::vector<Neighbour> lane;
        for (const double x : cars) {
            MovingBox car = disc({x + 8.0 * step / 60.0, 0}, 0.0, {8, 0});
            car.half = {2.25, 0.9};
            lane.push_back({car, 0.8, false, false});
        }
        if (step % 6 == 0) one.choose(lane);
        one.move(1.0 / 60.0);
        for (const Neighbour& car : lane) met = met || overlap(one.box(), car.box, 0.0);
        if (distance(one.at, one.goal) < 0.3) seconds = step / 60.0;
    }
    MESSAGE("one lane: " << seconds << " s");
    CHECK_FALSE(met);
    CHECK(seconds < 25.0);
}
