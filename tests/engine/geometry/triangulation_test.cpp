#include "engine/geometry/triangulation.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/maths.h"
#include "base/random.h"

using namespace muster;

namespace {

// `flattest`: what every triangle's area must exceed.
double areaOf(const TriangleMesh& mesh, double flattest = 0.0) {
    double area = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Polygon corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
        CHECK(signedArea(corners) > flattest);
        area += signedArea(corners);
    }
    return area;
}

// Counts circumcircles that hold a point, by brute force with a small tolerance.
int filledCircles(std::span<const Vec2> points, const std::vector<Triangle>& triangles) {
    int filled = 0;
    for (const Triangle& t : triangles) {
        const Vec2 a = points[t[0]], b = points[t[1]] - a, c = points[t[2]] - a;
        const double d = 2.0 * cross(b, c);
        const Vec2 u{(c.y * lengthSquared(b) - b.y * lengthSquared(c)) / d,
                     (b.x * lengthSquared(c) - c.x * lengthSquared(b)) / d};
        const double radius = length(u);
        for (Vec2 p : points) filled += distance(p, a + u) < radius * (1.0 - 1e-9) ? 1 : 0;
    }
    return filled;
}

Polygon circle(Vec2 centre, double radius, int count) {
    Polygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * kPi * i / count;
        polygon.push_back(centre + Vec2{cosine(angle), sine(angle)} * radius);
    }
    return polygon;
}

}  // namespace

TEST_CASE("delaunay fills the hull with triangles of empty circumcircles") {
    Random random(7);
    for (int round = 0; round < 40; ++round) {
        std::vector<Vec2> points;
        const int count = 3 + static_cast<int>(random.below(120));
        for (int i = 0; i < count; ++i) points.push_back({random.uniform(-5, 5), random.uniform(-5, 5)});
        const auto triangles = delaunay(points);
        REQUIRE(triangles.ok());
        CHECK(filledCircles(points, *triangles) == 0);
        CHECK(areaOf({points, *triangles}) == doctest::Approx(signedArea(convexHull(points))));
        const std::size_t hull = convexHull(points).size();
        CHECK(triangles->size() == 2 * points.size() - 2 - hull);  // Euler
    }
}

TEST_CASE("delaunay of lattices, where every circle is a tie") {
    for (const double step : {1.0, 0.1, 0.37}) {
        for (const double angle : {0.0, 0.3}) {
            std::vector<Vec2> points;
            const Rotation turn{cosine(angle), sine(angle)};
            for (int y = 0; y < 12; ++y) {
                for (int x = 0; x < 15; ++x) points.push_back(turn.apply({x * step, y * step}));
            }
            const auto triangles = delaunay(points);
            REQUIRE(triangles.ok());
            CHECK(filledCircles(points, *triangles) == 0);
            // Turned, the sides of the lattice are straight up to rounding only.
            CHECK(areaOf({points, *triangles}, -1e-15) == doctest::Approx(14 * 11 * step * step));
        }
    }
}

TEST_CASE("delaunay refuses what has no triangulation") {
    CHECK(!delaunay(std::vector<Vec2>{{0, 0}, {1, 0}}).ok());
    CHECK(!delaunay(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}, {5, 5}}).ok());
    CHECK(!delaunay(std::vector<Vec2>{{0, 0}, {0, 0}, {0, 0}}).ok());
    const auto repeated = delaunay(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}, {1, 0}});
    REQUIRE(!repeated.ok());
    CHECK(repeated.status().message() == "point 3 repeats an earlier point");
    CHECK(!delaunay(std::vector<Vec2>{{0, 0}, {1, 0}, {0, std::nan("")}}).ok());
}

TEST_CASE("a rectangle becomes a regular mesh") {
    const auto mesh = triangulate({{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}}, 0.5);
    REQUIRE(mesh.ok());
    CHECK(mesh->vertices.size() == 9 * 7);
    CHECK(mesh->triangles.size() == 2 * 8 * 6);
    CHECK(areaOf(*mesh) == doctest::Approx(12.0));
    const auto loops = boundaryLoops(*mesh);
    REQUIRE(loops.size() == 1);
    CHECK(loops[0].size() == 28);
}

TEST_CASE("outlines with holes keep their area, rim and spacing") {
    PolygonWithHoles shape{circle({1, 2}, 5, 40), {circle({0, 2}, 1.2, 17), {{2, 1}, {4, 1}, {3, 3}}}};
    std::reverse(shape.holes[0].begin(), shape.holes[0].end());
    const double exact = signedArea(shape.outline) + signedArea(shape.holes[0]) - signedArea(shape.holes[1]);
    for (const double spacing : {2.0, 0.7, 0.25}) {
        const auto mesh = triangulate(shape, spacing);
        REQUIRE(mesh.ok());
        CHECK(areaOf(*mesh) == doctest::Approx(exact));
        const auto loops = boundaryLoops(*mesh);
        REQUIRE(loops.size() == 3);
        int outer = 0;
        for (const auto& loop : loops) {
            Polygon rim;
            for (std::int32_t v : loop) rim.push_back(mesh->vertices[v]);
            outer += signedArea(rim) > 0 ? 1 : 0;
            for (std::size_t i = 0; i < rim.size(); ++i)
                CHECK(distance(rim[i], rim[(i + 1) % rim.size()]) <= spacing * (1 + 1e-9));
        }
        CHECK(outer == 1);
        // Every corner of the outline is a vertex.
        for (Vec2 p : shape.outline) CHECK(std::count(mesh->vertices.begin(), mesh->vertices.end(), p) == 1);
        std::set<std::int32_t> used;
        for (const Triangle& t : mesh->triangles) used.insert(t.begin(), t.end());
        CHECK(used.size() == mesh->vertices.size());
    }
}

TEST_CASE("thin and sharp outlines conform") {
    const Polygon comb{{0, 0},       {9, 0},    {9, 0.05}, {5, 0.05},   {5, 4},
                       {4.98, 0.06}, {3, 0.05}, {2.9, 4},  {2.8, 0.05}, {0, 0.04}};
    const Polygon spike{{0, 0}, {10, 0}, {10, 1}, {0.5, 0.01}, {10, 1.1}, {10, 5}, {0, 5}};
    for (const Polygon& outline : {comb, spike}) {
        const auto mesh = triangulate({outline, {}}, 0.5);
        REQUIRE(mesh.ok());
        CHECK(areaOf(*mesh) == doctest::Approx(signedArea(outline)));
        CHECK(boundaryLoops(*mesh).size() == 1);
    }
}

TEST_CASE("random star outlines are meshed exactly") {
    Random random(11);
    for (int round = 0; round < 60; ++round) {
        Polygon outline;
        const int count = 3 + static_cast<int>(random.below(20));
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * kPi * (i + 0.8 * random.uniform()) / count;
            outline.push_back(Vec2{cosine(angle), sine(angle)} * random.uniform(0.5, 6.0));
        }
        const auto clean = cleanPolygon(outline);
        if (!clean.ok()) continue;
        const auto mesh = triangulate({outline, {}}, random.uniform(0.3, 2.0));
        REQUIRE(mesh.ok());
        CHECK(areaOf(*mesh) == doctest::Approx(signedArea(*clean)));
    }
}

TEST_CASE("triangulate names what is wrong") {
    const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    CHECK(!triangulate({square, {}}, 0.0).ok());
    CHECK(!triangulate({square, {}}, std::nan("")).ok());
    CHECK(!triangulate({square, {}}, 1e-3).ok());
    CHECK(!triangulate({square, {}}, 1e-300).ok());
    CHECK(triangulate({square, {{{3, 3}, {5, 3}, {3, 5}}}}, 1.0).status().message() ==
          "hole 0 leaves the outline");
    CHECK(triangulate({square, {{{1, 1}, {2, 1}, {1, 2}}, {{1.2, 1.2}, {3, 1}, {3, 3}}}}, 1.0)
              .status()
              .message() == "hole 1 meets hole 0");
    CHECK(!triangulate({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}, 1.0).ok());
}

TEST_CASE("locate finds the triangle that holds a point, or the nearest rim point") {
    const auto mesh = triangulate({circle({0, 0}, 3, 24), {circle({0.5, 0}, 1, 12)}}, 0.5);
    REQUIRE(mesh.ok());
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Vec2 p{random.uniform(-4, 4), random.uniform(-4, 4)};
        const MeshPoint found = locate(mesh->triangles, mesh->vertices, p);
        CHECK(found.weight[0] + found.weight[1] + found.weight[2] == doctest::Approx(1.0));
        CHECK(std::min({found.weight[0], found.weight[1], found.weight[2]}) >= 0.0);
        double nearest = 1e9;
        for (const Triangle& t : mesh->triangles) {
            const Polygon corners{mesh->vertices[t[0]], mesh->vertices[t[1]], mesh->vertices[t[2]]};
            nearest = std::min(nearest, std::max(0.0, signedDistance(corners, p)));
        }
        CHECK(distance(found.position(mesh->triangles, mesh->vertices), p) ==
              doctest::Approx(nearest).epsilon(1e-9));
    }
}

TEST_CASE("barycentric coordinates reproduce points and survive flat triangles") {
    const auto w = barycentric({0, 0}, {2, 0}, {0, 2}, {0.5, 1.0});
    CHECK(w[0] == doctest::Approx(0.25));
    CHECK(w[1] == doctest::Approx(0.25));
    CHECK(w[2] == doctest::Approx(0.5));
    const auto flat = barycentric({0, 0}, {1, 0}, {3, 0}, {2, 5});
    CHECK(Vec2{flat[1] + 3 * flat[2], 0}.x == doctest::Approx(2.0));
    const auto point = barycentric({1, 1}, {1, 1}, {1, 1}, {2, 5});
    CHECK(point[0] + point[1] + point[2] == doctest::Approx(1.0));
}

TEST_CASE("loops that touch in one vertex stay apart") {
    const TriangleMesh mesh{{{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 1, 2}, {0, 3, 4}}};
    const auto loops = boundaryLoops(mesh);
    REQUIRE(loops.size() == 2);
    CHECK(loops[0].size() == 3);
    CHECK(loops[1].size() == 3);
}
