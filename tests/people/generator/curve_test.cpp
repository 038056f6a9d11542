#include "people/generator/curve.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

using namespace muster::generator;

namespace {

double rateOf(const Curve& curve, double time) {
    return (curve.at(time + 1e-6) - curve.at(time - 1e-6)) / 2e-6;
}

std::vector<Key> anyKeys() {
    const int count = *rc::gen::inRange(2, 9);
    std::vector<Key> keys;
    double time = 0.0;
    for (int i = 0; i < count; ++i) {
        keys.push_back({time, *rc::gen::inRange(-100, 101) / 50.0});
        time += *rc::gen::inRange(1, 10) / 10.0;
    }
    return keys;
}

}  // namespace

TEST_CASE("a spline with the right slopes is the cubic its keys came from") {
    const auto cubic = [](double t) { return 1.0 - 2.0 * t + 3.0 * t * t - t * t * t; };
    const auto slope = [](double t) { return -2.0 + 6.0 * t - 3.0 * t * t; };
    std::vector<Key> keys;
    for (double t : {0.0, 0.3, 0.9, 1.4, 2.0}) keys.push_back({t, cubic(t)});
    const Curve curve = Curve::spline(keys, slope(0.0), slope(2.0));
    for (double t = 0.0; t <= 2.0; t += 0.05) CHECK(curve.at(t) == doctest::Approx(cubic(t)));
}

TEST_CASE("curves pass their keys, smoothly, and are held outside") {
    CHECK(rc::check("both kinds", [] {
        const auto keys = anyKeys();
        for (const Curve& curve : {Curve::spline(keys, 0.3, -0.2), Curve::eased(keys)}) {
            for (const Key& key : keys) RC_ASSERT(std::fabs(curve.at(key.time) - key.value) < 1e-9);
            for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
                // Rates change by at most some 6 * 4 / 0.1^2 = 2,400 /s between values of -2 to 2, 0.1 s
                // apart.
                const double t = keys[i].time;
                RC_ASSERT(std::fabs(rateOf(curve, t - 3e-6) - rateOf(curve, t + 3e-6)) < 2 * 2400 * 6e-6);
            }
            RC_ASSERT(curve.at(-5.0) == keys.front().value);
            RC_ASSERT(curve.at(100.0) == keys.back().value);
        }
    }));
}

TEST_CASE("an eased curve never leaves the span of neighbouring keys") {
    CHECK(rc::check("no overshoot", [] {
        const auto keys = anyKeys();
        const Curve curve = Curve::eased(keys);
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            const double low = std::min(keys[i].value, keys[i + 1].value),
                         high = std::max(keys[i].value, keys[i + 1].value);
            for (int k = 0; k <= 20; ++k) {
                const double at = curve.at(keys[i].time + (keys[i + 1].time - keys[i].time) * k / 20.0);
                RC_ASSERT(at >= low - 1e-9);
                RC_ASSERT(at <= high + 1e-9);
            }
        }
    }));
}

TEST_CASE("rise and hump") {
    CHECK(rise(1.0, 2.0, 0.5) == 0.0);
    CHECK(rise(1.0, 2.0, 1.5) == doctest::Approx(0.5));
    CHECK(rise(1.0, 2.0, 3.0) == 1.0);
    CHECK(hump(0.0, 2.0, 1.0) == doctest::Approx(1.0));
    CHECK(hump(0.0, 2.0, -0.1) == 0.0);
    CHECK(hump(0.0, 2.0, 2.1) == 0.0);
    CHECK(hump(0.0, 2.0, 0.4) == doctest::Approx(hump(0.0, 2.0, 1.6)));
}
