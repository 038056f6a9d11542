#include "engine/geometry/triangulation.h"

#include <doctest.h>

#include <cmath>

#include "base/maths.h"
#include "base/random.h"

using namespace muster;

namespace {

// Convex parts, areas that add up, and every random point in as many parts as it should be.
void checkParts(const Polygon& outline, std::size_t most) {
    const auto parts = decomposeConvex(outline);
    REQUIRE(parts.ok());
    CHECK(parts->size() <= most);
    double area = 0.0;
    for (const Polygon& part : *parts) {
        CHECK(part.size() >= 3);
        CHECK(isConvex(part));
        CHECK(signedArea(part) > 0.0);
        area += signedArea(part);
    }
    CHECK(area == doctest::Approx(std::fabs(signedArea(outline))).epsilon(1e-12));
    const Box box = boundsOf(outline);
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Vec2 p{random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y)};
        int holding = 0;
        for (const Polygon& part : *parts) holding += containsPoint(part, p) ? 1 : 0;
        CHECK(holding == (containsPoint(outline, p) ? 1 : 0));
    }
}

}  // namespace

TEST_CASE("convex polygons come back as they are") {
    const Polygon square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
    const auto parts = decomposeConvex(square);
    REQUIRE(parts.ok());
    REQUIRE(parts->size() == 1);
    CHECK((*parts)[0] == square);
}

TEST_CASE("letters fall into few parts") {
    checkParts({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 2);                  // L
    checkParts({{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 3);  // U
    // +
    checkParts(
        {{2, 0}, {3, 0}, {3, 2}, {5, 2}, {5, 3}, {3, 3}, {3, 5}, {2, 5}, {2, 3}, {0, 3}, {0, 2}, {2, 2}}, 5);
    // Many corners in a row on straight lines.
    checkParts({{0, 0},
                {1, 0},
                {2, 0},
                {3, 0},
                {3, 1},
                {3, 3},
                {2, 3},
                {2, 2},
                {2, 1},
                {1, 1},
                {1, 2},
                {1, 3},
                {0, 3},
                {0, 2},
                {0, 1}},
               4);
    // Clockwise.
    checkParts({{0, 4}, {1, 4}, {1, 1}, {4, 1}, {4, 0}, {0, 0}}, 2);
}

TEST_CASE("random stars and combs are covered exactly") {
    Random random(21);
    for (int round = 0; round < 80; ++round) {
        Polygon outline;
        const int count = 4 + static_cast<int>(random.below(40));
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * kPi * (i + 0.7 * random.uniform()) / count;
            outline.push_back(Vec2{cosine(angle), sine(angle)} * random.uniform(0.3, 5.0));
        }
        if (!cleanPolygon(outline).ok()) continue;
        std::size_t reflex = 0;
        for (int i = 0; i < count; ++i) {
            const Vec2 a = outline[i], b = outline[(i + 1) % count], c = outline[(i + 2) % count];
            reflex += cross(b - a, c - b) < 0 ? 1 : 0;
        }
        checkParts(outline, 2 * reflex + 1);  // Hertel and Mehlhorn's bound
    }
    Polygon comb{{0, -1}, {100, -1}};
    for (int i = 100; i >= 0; --i) comb.push_back({static_cast<double>(i), i % 2 == 0 ? 5.0 : 0.0});
    checkParts(comb, 103);
}

TEST_CASE("bad outlines are refused") {
    CHECK(!decomposeConvex(Polygon{{0, 0}, {1, 1}, {1, 0}, {0, 1}}).ok());
    CHECK(!decomposeConvex(Polygon{{0, 0}, {1, 1}}).ok());
}
