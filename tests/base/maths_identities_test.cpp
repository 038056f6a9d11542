// Identities that hold of the elementary functions, whatever the library says; vectors and streams.
#include <doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "base/maths.h"
#include "base/random.h"
#include "muster/status.h"
#include "muster/vec2.h"

using namespace muster;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double worstOf(int count, const std::function<double(Random&)>& error) {
    Random random(21);
    double worst = 0.0;
    for (int i = 0; i < count; ++i) worst = std::fmax(worst, std::fabs(error(random)));
    return worst;
}

}  // namespace

TEST_CASE("sine and cosine: squares, oddness, quarter turns, sums of angles") {
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(-1000, 1000);
              return sine(a) * sine(a) + cosine(a) * cosine(a) - 1.0;
          }) < 1e-15);
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(-1000, 1000);
              return std::fmax(std::fabs(sine(-a) + sine(a)), std::fabs(cosine(-a) - cosine(a)));
          }) == 0.0);
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(-10, 10), b = r.uniform(-10, 10);
              return sine(a + b) - sine(a) * cosine(b) - cosine(a) * sine(b);
          }) < 4e-15);
    CHECK(sine(kPi / 6) == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(cosine(kPi / 3) == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(sine(kPi / 2) == 1.0);
    CHECK(cosine(kPi) == -1.0);
    CHECK(std::fabs(sine(kPi) - 1.2246467991473532e-16) < 1e-30);  // Of the double nearest to pi.
}

TEST_CASE("the arc tangent undoes sine and cosine, whatever the length") {
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(-3.14, 3.14), scale = exponential(r.uniform(-200, 200));
              return arcTangent2(scale * sine(a), scale * cosine(a)) - a;
          }) < 2e-15);
    CHECK(worstOf(20000, [](Random& r) {
              const double x = r.uniform(0.01, 5), y = r.uniform(0.01, 5);
              return arcTangent2(y, x) + arcTangent2(x, y) - kPi / 2;
          }) < 1e-15);
    CHECK(arcTangent2(1.0, 1.0) == doctest::Approx(kPi / 4).epsilon(1e-15));
    CHECK(arcTangent2(5e-324, 1.0) >= 0.0);
}

TEST_CASE("exponentials turn sums into products, logarithms the other way round") {
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(-300, 300), b = r.uniform(-300, 300);
              return exponential(a + b) / (exponential(a) * exponential(b)) - 1.0;
          }) < 2e-13);
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(1e-6, 1e6), b = r.uniform(1e-6, 1e6);
              return logarithm(a * b) - logarithm(a) - logarithm(b);
          }) < 2e-14);
    CHECK(worstOf(20000, [](Random& r) {
              const double a = r.uniform(-20, 20);
              return logarithm(exponential(a)) - a;
          }) < 1e-13);
    CHECK(exponential(0.0) == 1.0);
    CHECK(exponential(1.0) == doctest::Approx(2.718281828459045).epsilon(1e-15));
    for (int k = -1070; k <= 1020; k += 55)
        CHECK(logarithm(std::ldexp(1.0, k)) == doctest::Approx(k * 0.69314718055994530942).epsilon(1e-15));
}

TEST_CASE("the ends of the range: denormals, infinities and numbers that are none") {
    CHECK(std::fabs(exponential(-744.0) - 1e-323) <= 5e-324);
    CHECK(exponential(-708.0) == doctest::Approx(std::exp(-708.0)).epsilon(1e-14));
    CHECK(exponential(709.6) == doctest::Approx(std::exp(709.6)).epsilon(1e-13));
    CHECK(exponential(-kInfinity) == 0.0);
    CHECK(exponential(kInfinity) == kInfinity);
    CHECK(std::isnan(exponential(kNan)));
    CHECK(logarithm(5e-324) == doctest::Approx(std::log(5e-324)).epsilon(1e-15));
    CHECK(logarithm(kInfinity) == kInfinity);
    CHECK(std::isnan(logarithm(-1.0)));
    CHECK(std::isnan(logarithm(kNan)));
    CHECK(std::isfinite(sine(1e300)));
    CHECK(std::isfinite(cosine(kNan)));
}

TEST_CASE("powers obey their laws and rise with base and exponent") {
    CHECK(worstOf(5000, [](Random& r) {
              const double b = r.uniform(0.01, 50), e = r.uniform(0.1, 6), f = r.uniform(0.1, 6);
              return power(b, e + f) / (power(b, e) * power(b, f)) - 1.0;
          }) < 1e-12);
    CHECK(worstOf(5000, [](Random& r) {
              const double b = r.uniform(0, 50);
              return power(power(b, 1.5), 2.0) - b * b * b;
          }) < 1e-8);
    double last = -1.0;
    for (int i = 0; i < 2000; ++i) {
        const double value = power(i * 0.01, 2.5);
        CHECK(value > last);
        last = value;
    }
    CHECK(power(7.0, 0.0) == 1.0);
    CHECK(power(0.0, 0.0) == 1.0);
    CHECK(power(0.0, -1.0) == kInfinity);
    CHECK(power(1.0, 123.4) == 1.0);
    CHECK(power(3.0, 4.0) == 81.0);
}

TEST_CASE("vectors: products, turns, limits and boxes") {
    Random random(22);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 a{random.uniform(-9, 9), random.uniform(-9, 9)},
            b{random.uniform(-9, 9), random.uniform(-9, 9)};
        CHECK(cross(a, b) == -cross(b, a));
        CHECK(dot(a, perpendicular(a)) == 0.0);
        CHECK(dot(a, b) * dot(a, b) + cross(a, b) * cross(a, b) ==
              doctest::Approx(lengthSquared(a) * lengthSquared(b)));
        CHECK(length(clampLength(a, 2.0)) <= 2.0 + 1e-12);
        CHECK(std::fabs(cross(clampLength(a, 2.0), a)) < 1e-12);
        const double angle = random.uniform(-4, 4);
        const Pose pose{b, {cosine(angle), sine(angle)}};
        CHECK(distance(pose.applyInverse(pose.apply(a)), a) < 1e-13);
        CHECK(length(pose.rotation.apply(a)) == doctest::Approx(length(a)));
        const Box box{{-2, -1}, {3, 4}};
        CHECK(box.contains(box.clamp(a)));
        CHECK((box.clamp(a) == a) == box.contains(a));
        CHECK(box.grown(9.0).contains(a));
    }
    CHECK(normalized(Vec2{1e-13, 0}, Vec2{0, 1}) == Vec2{0, 1});
    CHECK(clampLength({0.3, 0.4}, 0.5) == Vec2{0.3, 0.4});
    CHECK(lerp({1, 2}, {3, 6}, 0.25) == Vec2{1.5, 3});
    CHECK_FALSE(isFinite(Vec2{kNan, 0}));
    CHECK_FALSE(isFinite(Vec2{0, kInfinity}));
}

TEST_CASE("streams of random numbers differ by seed and keep to their bounds") {
    std::set<std::uint32_t> firsts;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) firsts.insert(Random(seed).next());
    CHECK(firsts.size() >= 999);
    Random random(23);
    for (const std::uint32_t bound : {1u, 2u, 3u, 1000u, 0x80000001u}) {
        for (int i = 0; i < 200; ++i) CHECK(random.below(bound) < bound);
    }
    for (int i = 0; i < 2000; ++i) {
        const double value = random.uniform(-2.0, 5.0);
        CHECK(value >= -2.0);
        CHECK(value < 5.0);
    }
    Random once(9), again(9);
    for (int i = 0; i < 100; ++i) CHECK(once.next() == again.next());
}

TEST_CASE("a status keeps its kind when it is put into context, success stays success") {
    const Status bad = invalidArgument("radius is -1");
    CHECK(bad.within("obstacles[2]").message() == "obstacles[2]: radius is -1");
    CHECK(bad.within("obstacles[2]").code() == StatusCode::InvalidArgument);
    CHECK(Status().within("anything").ok());
    CHECK(Status().within("anything").message().empty());
    Result<std::string> result(std::string("value"));
    CHECK(result.ok());
    CHECK(result.status().ok());
    CHECK(result->size() == 5);
    CHECK(std::move(result).value() == "value");
    const Result<int> none(bad);
    CHECK_FALSE(none.ok());
    CHECK(none.status().message() == "radius is -1");
}
