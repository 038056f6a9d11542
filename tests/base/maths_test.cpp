#include "base/maths.h"

#include <doctest.h>

#include <cmath>
#include <limits>

#include "base/random.h"

using namespace muster;

TEST_CASE("sine and cosine agree with the long double library functions") {
    Random random(1);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double scale = i % 2 == 0 ? 10.0 : 1e5;
        const double angle = random.uniform(-scale, scale);
        worst = std::fmax(
            worst, std::fabs(sine(angle) - static_cast<double>(std::sin(static_cast<long double>(angle)))));
        worst = std::fmax(
            worst, std::fabs(cosine(angle) - static_cast<double>(std::cos(static_cast<long double>(angle)))));
    }
    CHECK(worst < 1e-15);
    CHECK(sine(0.0) == 0.0);
    CHECK(cosine(0.0) == 1.0);
    CHECK(std::isfinite(sine(std::numeric_limits<double>::infinity())));
}

TEST_CASE("the arc tangent covers all quadrants and the axes") {
    Random random(2);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double x = random.uniform(-3.0, 3.0);
        const double y = random.uniform(-3.0, 3.0);
        const auto exact = static_cast<double>(
            std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
        worst = std::fmax(worst, std::fabs(arcTangent2(y, x) - exact));
    }
    CHECK(worst < 1e-15);
    CHECK(arcTangent2(0.0, 0.0) == 0.0);
    CHECK(arcTangent2(0.0, -1.0) == doctest::Approx(kPi).epsilon(1e-15));
    CHECK(arcTangent2(-1.0, 0.0) == doctest::Approx(-kPi / 2).epsilon(1e-15));
}

TEST_CASE("exponential and logarithm are accurate and inverse to each other") {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const double x = random.uniform(-700.0, 700.0);
        const auto exact = static_cast<double>(std::exp(static_cast<long double>(x)));
        CHECK(std::fabs(exponential(x) - exact) <= 1e-14 * exact);
        const double positive = exponential(random.uniform(-300.0, 300.0));
        CHECK(logarithm(positive) == doctest::Approx(std::log(positive)).epsilon(1e-14));
    }
    CHECK(exponential(-1000.0) == 0.0);
    CHECK(std::isinf(exponential(1000.0)));
    CHECK(std::isinf(logarithm(0.0)));
    CHECK(logarithm(1.0) == 0.0);
}

TEST_CASE("powers: whole exponents are exact products") {
    CHECK(power(3.0, 2.0) == 9.0);
    CHECK(power(3.0, 1.0) == 3.0);
    CHECK(power(2.0, 3.0) == 8.0);
    CHECK(power(0.0, 1.5) == 0.0);
    CHECK(power(7.25, 1.5) == doctest::Approx(std::pow(7.25, 1.5)).epsilon(1e-13));
}
