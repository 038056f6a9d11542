// Own clocks and pins of edited people.
#include <doctest.h>

#include <cmath>

#include "files/edits/edited_path.h"

using namespace muster;

namespace {

TEST_CASE("edited path: each pin is met exactly, and the path is smooth between them") {
    const std::vector<PathPin> pins{{1.0, {1.0, 0.5}, 3.0}, {2.0, {-2.0, 1.0}, 0.4}, {6.0, {0.0, 3.0}, 2.0}};
    for (const PathPin& pin : pins) {
        CHECK(pinMove(pins, pin.time).offset == pin.offset);
        CHECK(length(pinMove(pins, pin.time).velocity) == 0.0);
    }
    CHECK(pinMove(pins, 3.0).offset == Vec2{});
    CHECK(pinMove(pins, 8.0).offset == Vec2{});
    CHECK(pinMove(pins, 20.0).velocity == Vec2{});
    // The velocity is the derivative, bounded by the steepest slope of a pin, and continuous.
    Vec2 before = pinMove(pins, -3.0).velocity;
    for (double t = -3.0; t < 9.0; t += 1e-3) {
        const PinMove here = pinMove(pins, t);
        const Vec2 slope = (pinMove(pins, t + 1e-6).offset - pinMove(pins, t - 1e-6).offset) / 2e-6;
        CHECK(distance(slope, here.velocity) < 1e-4);
        CHECK(length(here.velocity) <=
              1.875 * (length(Vec2{1.0, 0.5}) / 1.0 + length(Vec2{2.0, 1.0}) / 0.4) + 1e-9);
        CHECK(distance(before, here.velocity) < 0.2);
        before = here.velocity;
    }
}

TEST_CASE("edited path: equal pins near each other carry the path between them along") {
    const std::vector<PathPin> pins{{2.0, {1.0, -1.0}, 5.0}, {4.0, {1.0, -1.0}, 5.0}};
    for (double t = 2.0; t <= 4.0; t += 0.05) CHECK(distance(pinMove(pins, t).offset, {1.0, -1.0}) < 1e-12);
}

TEST_CASE("edited path: an own clock is monotone, goes through its points, and as usual outside") {
    const OwnClock clock({{2.0, 2.0}, {5.0, 4.0}, {7.0, 4.0}, {9.0, 8.0}, {11.0, 9.5}});
    CHECK(clock.at(1.0).time == 1.0);
    CHECK(clock.at(1.0).rate == 1.0);
    CHECK(clock.at(5.0).time == doctest::Approx(4.0).epsilon(1e-12));
    CHECK(clock.at(9.0).time == doctest::Approx(8.0).epsilon(1e-12));
    CHECK(clock.at(15.0).time == doctest::Approx(13.5));
    CHECK(clock.at(15.0).rate == 1.0);
    OwnTime before = clock.at(0.0);
    for (double t = 0.0; t < 14.0; t += 1e-3) {
        const OwnTime here = clock.at(t);
        CHECK(here.time >= before.time - 1e-12);
        CHECK(std::fabs(here.rate - before.rate) < 0.02);
        const double slope = (clock.at(t + 1e-6).time - clock.at(t - 1e-6).time) / 2e-6;
        CHECK(std::fabs(slope - here.rate) < 1e-3);
        before = here;
    }
    CHECK(clock.when(1.5) == 1.5);
    CHECK(clock.when(12.0) == doctest::Approx(13.5));
    CHECK(clock.at(clock.when(3.3)).time == doctest::Approx(3.3));
    CHECK(OwnClock({}).at(3.25).time == 3.25);
}

}  // namespace
