// Rotations in space against a second way: matrices by Rodrigues' formula.
#include "muster/quat.h"
#include "base/maths.h"

#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"

using namespace muster;

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix rodrigues(Vec3 axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), t = 1.0 - c;
    const double x = axis.x, y = axis.y, z = axis.z;
    return {{{t * x * x + c, t * x * y - s * z, t * x * z + s * y},
             {t * x * y + s * z, t * y * y + c, t * y * z - s * x},
             {t * x * z - s * y, t * y * z + s * x, t * z * z + c}}};
}

Vec3 product(const Matrix& m, Vec3 v) {
    const auto row = [&](std::size_t i) {
        return static_cast<float>(m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z);
    };
    return {row(0), row(1), row(2)};
}

Vec3 unitVector(Random& random) {
    for (;;) {
        const Vec3 v{static_cast<float>(random.uniform(-1.0, 1.0)),
                     static_cast<float>(random.uniform(-1.0, 1.0)),
                     static_cast<float>(random.uniform(-1.0, 1.0))};
        if (lengthSquared(v) > 0.01f && lengthSquared(v) < 1.0f) return normalized(v);
    }
}

void checkNear(Vec3 a, Vec3 b, float within = 2e-6f) {
    CHECK_MESSAGE(distance(a, b) <= within, "(" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x
                                                << ", " << b.y << ", " << b.z << ")");
}

}  // namespace

TEST_CASE("A turn by a quaternion is the turn by its matrix") {
    Random random(7);
    for (int i = 0; i < 200; ++i) {
        const Vec3 axis = unitVector(random), v = unitVector(random);
        const double angle = random.uniform(-7.0, 7.0);
        checkNear(rotate(axisAngle(axis, angle), v), product(rodrigues(axis, angle), v));
    }
}

TEST_CASE("Products turn first by the right, then by the left; the conjugate undoes") {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const Quat a = axisAngle(unitVector(random), random.uniform(-3.0, 3.0));
        const Quat b = axisAngle(unitVector(random), random.uniform(-3.0, 3.0));
        const Vec3 v = unitVector(random);
        checkNear(rotate(a * b, v), rotate(a, rotate(b, v)));
        checkNear(rotate(conjugate(a), rotate(a, v)), v);
    }
}

TEST_CASE("To the left is positive about the vertical") {
    checkNear(rotate(yawTurn(kPi / 2), {1.0f, 0.0f, 0.0f}), {0.0f, 1.0f, 0.0f});
    checkNear(rotate(axisAngle({1, 0, 0}, kPi / 2), {0.0f, 1.0f, 0.0f}), {0.0f, 0.0f, 1.0f});
}

TEST_CASE("The shortest arc takes one direction to the other and turns by the angle between them") {
    Random random(9);
    for (int i = 0; i < 200; ++i) {
        const Vec3 from = unitVector(random), to = unitVector(random);
        const Quat arc = shortestArc(from, to);
        checkNear(rotate(arc, from), to, 2e-5f);
        CHECK(angleBetween({}, arc) ==
              doctest::Approx(std::acos(std::clamp(dot(from, to), -1.0f, 1.0f))).epsilon(1e-3));
        checkNear(rotate(shortestArc(from, -from), from), -from, 2e-5f);
    }
}

TEST_CASE("nlerp is exact at both ends, takes the shorter way and never leaves the arc") {
    Random random(10);
    for (int i = 0; i < 200; ++i) {
        const Vec3 axis = unitVector(random);
        const double angle = random.uniform(0.1, 3.0), t = random.uniform(0.0, 1.0);
        const Quat a = axisAngle(axis, 0.3), b = axisAngle(axis, 0.3 + angle);
        CHECK(angleBetween(nlerp(a, b, 0.0f), a) < 1e-3);
        CHECK(angleBetween(nlerp(a, b, 1.0f), b) < 1e-3);
        const Quat between = nlerp(a, -b, static_cast<float>(t));
        CHECK(dot(between, between) == doctest::Approx(1.0));
        CHECK(angleBetween(a, between) + angleBetween(between, b) == doctest::Approx(angle).epsilon(2e-3));
    }
    CHECK(angleBetween({}, nlerp({}, axisAngle({0, 0, 1}, 1.0), 0.5f)) == doctest::Approx(0.5).epsilon(1e-4));
}

TEST_CASE("What is no rotation becomes none") {
    CHECK(normalized(Quat{0.0f, 0.0f, 0.0f, 0.0f}).w == 1.0f);
    checkNear(normalized(Vec3{}, {0.0f, 0.0f, 1.0f}), {0.0f, 0.0f, 1.0f});
}

TEST_CASE("Transforms: one after the other") {
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        const Transform a{axisAngle(unitVector(random), random.uniform(-3.0, 3.0)), unitVector(random)};
        const Transform b{axisAngle(unitVector(random), random.uniform(-3.0, 3.0)), unitVector(random)};
        const Vec3 p = unitVector(random);
        checkNear((a * b).apply(p), a.apply(b.apply(p)));
    }
}
