// Distortion of meshes, against cases worked out by hand.
#include "lab/reproduce/experiments/distortion.h"

#include <doctest.h>

#include <cmath>
#include <functional>

using namespace muster;

namespace {

/// Two triangles: one at the left of x = 0 with an area of 1, one at the right with an area of 3.
TriangleMesh twoTriangles() {
    return {{{-2.0, 0.0}, {-1.0, 0.0}, {-2.0, 2.0}, {1.0, 0.0}, {4.0, 0.0}, {1.0, 2.0}},
            {{0, 1, 2}, {3, 4, 5}}};
}

std::vector<Vec2> mapped(const TriangleMesh& mesh, const std::function<Vec2(Vec2)>& map) {
    std::vector<Vec2> points;
    for (const Vec2 p : mesh.vertices) points.push_back(map(p));
    return points;
}

Vec2 turned(Vec2 p, double angle) {
    return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

/// Both triangles have the value.
void expectAll(const std::function<Vec2(Vec2)>& map, double value) {
    const TriangleMesh mesh = twoTriangles();
    for (const double each : triangleDistortion(mesh, mapped(mesh, map)))
        CHECK(each == doctest::Approx(value).epsilon(1e-12));
    CHECK(arapEnergy(mesh, mapped(mesh, map)) == doctest::Approx(4.0 * value * value).epsilon(1e-12));
    CHECK(meanDistortion(mesh, mapped(mesh, map), true) == doctest::Approx(value).epsilon(1e-12));
}

/// |F - R| by trying rotations all round: a second algorithm.
double byTrying(double a, double b, double c, double d) {
    double best = 1e300;
    for (int k = 0; k < 200000; ++k) {
        const double angle = 2.0 * 3.14159265358979323846 * k / 200000.0, x = std::cos(angle),
                     y = std::sin(angle);
        best = std::min(best, (a - x) * (a - x) + (b + y) * (b + y) + (c - y) * (c - y) + (d - x) * (d - x));
    }
    return std::sqrt(best);
}

}  // namespace

TEST_CASE("what is moved rigidly is not distorted") {
    const TriangleMesh mesh = twoTriangles();
    for (const double angle : {0.0, 0.3, 1.5707963267948966, 3.0, -2.2}) {
        for (const double value : triangleDistortion(mesh, mapped(mesh, [&](Vec2 p) {
                                                         return turned(p, angle) + Vec2{7.0, -3.0};
                                                     })))
            CHECK(std::abs(value) < 1e-7);  // A root of rounding errors.
    }
}

TEST_CASE("a scale by k is |k - 1| root 2, whatever the rotation") {
    for (const double scale : {1.1, 0.5, 3.0, 0.0}) {
        expectAll([&](Vec2 p) { return p * scale; }, std::abs(scale - 1.0) * std::sqrt(2.0));
        expectAll([&](Vec2 p) { return turned(p, 1.1) * scale; }, std::abs(scale - 1.0) * std::sqrt(2.0));
    }
}

TEST_CASE("a stretch along one axis is its own deviation from 1") {
    expectAll([](Vec2 p) { return Vec2{1.7 * p.x, p.y}; }, 0.7);
    expectAll([](Vec2 p) { return Vec2{p.x, 0.25 * p.y}; }, 0.75);
}

TEST_CASE("a shear, by hand: F^T F has trace 2 + s^2 and F determinant 1") {
    // (s1 + s2)^2 = 4 + s^2, so (s1 - 1)^2 + (s2 - 1)^2 = 2 + s^2 - 2 sqrt(4 + s^2) + 2.
    for (const double s : {0.5, 1.0, -2.0})
        expectAll(
            [&](Vec2 p) {
                return Vec2{p.x + s * p.y, p.y};
            },
            std::sqrt(4.0 + s * s - 2.0 * std::sqrt(4.0 + s * s)));
}

TEST_CASE("a triangle turned inside out is 2 away from the nearest rotation") {
    expectAll([](Vec2 p) { return Vec2{-p.x, p.y}; }, 2.0);
    expectAll([](Vec2 p) { return turned({p.x, -p.y}, 0.8); }, 2.0);
}

TEST_CASE("any linear map, against trying all rotations") {
    const double maps[][4] = {{1.3, 0.4, -0.2, 0.8},
                              {0.1, -1.0, 2.0, 0.3},
                              {-0.7, 0.9, 1.1, 0.4},
                              {0.0, 1.0, 1.0, 0.0},
                              {-1.5, 0.0, 0.2, -0.1}};
    const TriangleMesh mesh = twoTriangles();
    for (const auto& m : maps) {
        const auto values = triangleDistortion(
            mesh, mapped(mesh, [&](Vec2 p) {
                return Vec2{m[0] * p.x + m[1] * p.y, m[2] * p.x + m[3] * p.y};
            }));
        for (const double value : values)
            CHECK(value == doctest::Approx(byTrying(m[0], m[1], m[2], m[3])).epsilon(1e-6));
    }
}

TEST_CASE("halves are distinguished by where triangles were at rest, areas weigh") {
    TriangleMesh mesh = twoTriangles();
    // A third triangle at the right, of area 1; only the one at the left and this one are stretched.
    mesh.vertices.insert(mesh.vertices.end(), {{6.0, 0.0}, {8.0, 0.0}, {6.0, 1.0}});
    mesh.triangles.push_back({6, 7, 8});
    std::vector<Vec2> now = mesh.vertices;
    for (const std::size_t i : {0u, 1u, 2u}) now[i] = {now[i].x * 1.5 + 20.0, now[i].y};
    for (const std::size_t i : {6u, 7u, 8u}) now[i].y *= 3.0;
    CHECK(meanDistortion(mesh, now, true) == doctest::Approx(0.5));
    CHECK(meanDistortion(mesh, now, false) == doctest::Approx(2.0 * 1.0 / (3.0 + 1.0)));
    CHECK(arapEnergy(mesh, now) == doctest::Approx(1.0 * 0.25 + 1.0 * 4.0));
    CHECK(meanDistortion({}, {}, true) == 0.0);
}
