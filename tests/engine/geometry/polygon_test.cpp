#include "engine/geometry/polygon.h"

#include <doctest.h>

#include <cmath>

#include "base/random.h"

using namespace muster;

namespace {
const Polygon kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Polygon kHook{{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 1}, {0, 1}};
}  // namespace

TEST_CASE("area, centroid, bounds and convexity of known shapes") {
    CHECK(signedArea(kSquare) == 4.0);
    CHECK(signedArea(Polygon{{0, 0}, {0, 2}, {2, 2}, {2, 0}}) == -4.0);
    CHECK(signedArea(kHook) == 8.0);
    CHECK(centroid(kSquare) == Vec2{1, 1});
    // 4 x 1 and 2 x 2 parts with centres (2, 0.5) and (3, 2).
    CHECK(centroid(kHook).x == doctest::Approx(2.5));
    CHECK(centroid(kHook).y == doctest::Approx(1.25));
    CHECK(centroid(Polygon{{0, 0}, {1, 1}, {2, 2}}).x == doctest::Approx(1.0));
    CHECK(centroid(Polygon{{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6, 1e6 + 1}}).x ==
          doctest::Approx(1e6 + 1.0 / 3).epsilon(1e-12));
    CHECK(boundsOf(kHook).max == Vec2{4, 3});
    CHECK(isConvex(kSquare));
    CHECK(!isConvex(kHook));
    CHECK(isConvex(Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST_CASE("points inside, outside and on the boundary") {
    CHECK(containsPoint(kHook, {1, 0.5}));
    CHECK(!containsPoint(kHook, {1, 2}));
    for (std::size_t i = 0; i < kHook.size(); ++i) {
        CHECK(containsPoint(kHook, kHook[i]));
        CHECK(containsPoint(kHook, lerp(kHook[i], kHook[(i + 1) % kHook.size()], 0.3)));
    }
    CHECK(!containsPoint(kSquare, {2.0 + 1e-9, 1}));
    const PolygonWithHoles ring{kSquare, {{{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}}}};
    CHECK(containsPoint(ring, {0.2, 1}));
    CHECK(!containsPoint(ring, {1, 1}));
}

TEST_CASE("distances agree with dense sampling of the boundary") {
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const Vec2 p{random.uniform(-2, 6), random.uniform(-2, 5)};
        double nearest = 1e9;
        for (std::size_t k = 0; k < kHook.size(); ++k) {
            for (int s = 0; s <= 400; ++s)
                nearest = std::min(nearest,
                                   distance(p, lerp(kHook[k], kHook[(k + 1) % kHook.size()], s / 400.0)));
        }
        const double d = signedDistance(kHook, p);
        CHECK(std::fabs(d) <= nearest + 1e-12);
        CHECK(std::fabs(d) >= nearest - 0.006);
        const bool inside = p.x > 0 && p.y > 0 && p.x < 4 && p.y < 3 && !(p.x < 2 && p.y > 1);
        CHECK((d < 0) == inside);
        CHECK(closestOnBoundary(kHook, p).distance == doctest::Approx(std::fabs(d)));
    }
}

TEST_CASE("segment distances agree with sampling, and crossings with zero distance") {
    Random random(9);
    const auto point = [&] { return Vec2{random.uniform(-2, 6), random.uniform(-2, 5)}; };
    int crossings = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec2 a = point(), b = point(), c = point(), d = point();
        double nearest = 1e9, nearestArea = 1e9;
        for (int s = 0; s <= 300; ++s) {
            const Vec2 p = lerp(a, b, s / 300.0);
            nearest = std::min(nearest, distance(closestOnSegment(c, d, p), p));
            nearestArea = std::min(nearestArea, std::max(0.0, signedDistance(kHook, p)));
        }
        CHECK(segmentDistance(a, b, c, d) <= nearest + 1e-12);
        CHECK(segmentDistance(a, b, c, d) >= nearest - 0.03);
        CHECK(segmentDistance(kHook, a, b) <= nearestArea + 1e-12);
        CHECK(segmentDistance(kHook, a, b) >= nearestArea - 0.03);
        CHECK(segmentsCross(a, b, c, d) == (segmentDistance(a, b, c, d) == 0.0));
        crossings += segmentsCross(a, b, c, d) ? 1 : 0;
    }
    CHECK(crossings > 20);
    CHECK(segmentsCross({0, 0}, {2, 0}, {1, 0}, {3, 0}));
    CHECK(segmentsCross({0, 0}, {2, 0}, {2, 0}, {3, 1}));
    CHECK(!segmentsCross({0, 0}, {2, 0}, {2.1, 0}, {3, 0}));
    CHECK(segmentDistance({0, 0}, {0, 0}, {3, 4}, {3, 4}) == 5.0);
}

TEST_CASE("predicates are exact where doubles are not") {
    // A step of one unit in the last place decides.
    const double tick = std::ldexp(1.0, -52);
    CHECK(orientation({0.5, 0.5}, {12, 12}, {24, 24}) == 0);
    CHECK(orientation({0.5, 0.5 + tick}, {12, 12}, {24, 24}) ==
          -orientation({0.5 + tick, 0.5}, {12, 12}, {24, 24}));
    CHECK(orientation({0.5, 0.5 + tick}, {12, 12}, {24, 24}) != 0);
    // Lattice points on one circle, then moved by a hair.
    const Vec2 base{0.1, 0.7};
    CHECK(inCircle({0, 0}, {1, 0}, {1, 1}, {0, 1}) == 0);
    CHECK(inCircle({0, 0}, {1, 0}, {1, 1}, {0, std::nextafter(1.0, 0.0)}) == 1);
    CHECK(inCircle({0, 0}, {1, 0}, {1, 1}, {0, std::nextafter(1.0, 2.0)}) == -1);
    CHECK(inCircle(base, base + Vec2{3, 0}, base + Vec2{0, 3}, base + Vec2{1, 1}) == 1);
    // All orders of three points agree, at every offset on a fine lattice round a line.
    for (int i = -20; i <= 20; ++i) {
        for (int j = -20; j <= 20; ++j) {
            const Vec2 p{0.5 + i * tick, 0.5 + j * tick}, q{12, 12}, r{24, 24};
            CHECK(orientation(p, q, r) == orientation(q, r, p));
            CHECK(orientation(p, q, r) == -orientation(q, p, r));
            CHECK(orientation(p, q, r) == (i == j ? 0 : (i < j ? -1 : 1)) * orientation({1, 0}, q, r));
        }
    }
}

TEST_CASE("convex hull holds all points and turns left") {
    Random random(2);
    std::vector<Vec2> points;
    for (int i = 0; i < 200; ++i)
        points.push_back({std::floor(random.uniform(0, 12)), std::floor(random.uniform(0, 9))});
    const Polygon hull = convexHull(points);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 a = hull[i], b = hull[(i + 1) % hull.size()];
        CHECK(orientation(a, b, hull[(i + 2) % hull.size()]) > 0);
        for (Vec2 p : points) CHECK(cross(b - a, p - a) >= 0.0);
    }
    CHECK(convexHull(std::vector<Vec2>{{1, 1}, {1, 1}}).size() == 1);
    CHECK(convexHull(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}}).size() == 2);
}

TEST_CASE("cleanPolygon mends what it can and names what it cannot") {
    const auto clean = cleanPolygon(Polygon{{0, 0}, {0, 0}, {0, 2}, {2, 2}, {2, 0}, {0, 0}});
    REQUIRE(clean.ok());
    CHECK(*clean == kSquare);
    const auto message = [](const Polygon& p) { return cleanPolygon(p).status().message(); };
    CHECK(message({}) == "a polygon needs three distinct corners, found 0");
    CHECK(message({{0, 0}, {1, 0}, {0, 0}, {0, 0}}) == "a polygon needs three distinct corners, found 2");
    CHECK(message({{0, 0}, {2, 2}, {2, 0}, {0, 2}}) == "edges 0 and 2 of the polygon cross or touch");
    CHECK(message({{0, 0}, {0, 0}, {2, 2}, {2, 0}, {0, 2}}) == "edges 0 and 3 of the polygon cross or touch");
    CHECK(message({{0, 0}, {4, 0}, {2, 0}}) != "");
    CHECK(message({{0, 0}, {4, 0}, {4, 4}, {4, 2}}) != "");
    CHECK(message({{0, 0}, {1e-6, 0}, {0, 1e-6}}) == "the polygon's area is under 1e-9 square metres");
    CHECK(message({{0, 0}, {1, 0}, {INFINITY, 1}}).find("corner 2") == 0);
    CHECK(message({{0, 0}, {1, 0}, {1e300, 1}}).find("corner 2") == 0);
}
