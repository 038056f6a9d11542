#include "engine/geometry/free_area.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

using namespace muster;

namespace {

constexpr Box kBox{{0, 0}, {10, 6}};

Polygon rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double areaOf(const std::vector<PolygonWithHoles>& parts) {
    double sum = 0.0;
    for (const PolygonWithHoles& part : parts) {
        sum += signedArea(part.outline);
        for (const Polygon& hole : part.holes) {
            CHECK(signedArea(hole) < 0.0);
            sum += signedArea(hole);
        }
    }
    return sum;
}

bool isFree(const std::vector<PolygonWithHoles>& parts, Vec2 p) {
    return std::any_of(parts.begin(), parts.end(),
                       [p](const PolygonWithHoles& part) { return containsPoint(part, p); });
}

/// A convex polygon around a point in the box.
Polygon randomConvex() {
    const Vec2 centre{*rc::gen::inRange(-10, 110) * 0.1, *rc::gen::inRange(-10, 70) * 0.1};
    std::vector<Vec2> points(static_cast<std::size_t>(*rc::gen::inRange(3, 9)));
    for (Vec2& p : points)
        p = centre + Vec2{*rc::gen::inRange(-20, 21) * 0.1, *rc::gen::inRange(-20, 21) * 0.1};
    return convexHull(points);
}

}  // namespace

TEST_CASE("the free area of an empty box is the box") {
    const auto parts = freeArea(kBox, {});
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].outline == rectangle(0, 0, 10, 6));
    CHECK(parts[0].holes.empty());
}

TEST_CASE("obstacles that touch or overlap leave one hole") {
    const std::vector<Polygon> touching{rectangle(2, 2, 4, 4), rectangle(4, 2, 5, 4), rectangle(3, 3, 6, 5)};
    const auto parts = freeArea(kBox, touching);
    REQUIRE(parts.size() == 1);
    REQUIRE(parts[0].holes.size() == 1);
    CHECK(parts[0].holes[0].size() == 8);
    CHECK(areaOf(parts) == doctest::Approx(60.0 - (3 * 2 + 3 * 2 - 2 * 1)));
    // The same obstacle twice is the same as once.
    const std::vector<Polygon> twice{touching[0], touching[0]};
    CHECK(areaOf(freeArea(kBox, twice)) == doctest::Approx(56.0));
}

TEST_CASE("an obstacle across the box parts it, one around it leaves nothing") {
    const std::vector<Polygon> wall{rectangle(4, -1, 5, 7)};
    const auto parts = freeArea(kBox, wall);
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].outline == rectangle(0, 0, 4, 6));
    CHECK(parts[1].outline == rectangle(5, 0, 10, 6));
    const std::vector<Polygon> all{rectangle(-1, -1, 11, 7)};
    CHECK(freeArea(kBox, all).empty());
    const std::vector<Polygon> exactly{rectangle(0, 0, 10, 6)};
    CHECK(freeArea(kBox, exactly).empty());
}

TEST_CASE("an island in a court is a part of its own") {
    const std::vector<Polygon> court{rectangle(2, 1, 8, 2), rectangle(2, 4, 8, 5), rectangle(2, 1, 3, 5),
                                     rectangle(7, 1, 8, 5)};
    const auto parts = freeArea(kBox, court);
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].holes.size() == 1);
    CHECK(parts[1].outline == rectangle(3, 2, 7, 4));
}

TEST_CASE("obstacles that meet in a corner part nothing but the corner") {
    const std::vector<Polygon> two{rectangle(2, 2, 4, 4), rectangle(4, 4, 6, 5)};
    const auto parts = freeArea(kBox, two);
    REQUIRE(parts.size() == 1);
    CHECK(areaOf(parts) == doctest::Approx(60.0 - 4.0 - 2.0));
}

TEST_CASE("a point is free where no obstacle holds it") {
    CHECK(rc::check("random obstacles", [] {
        std::vector<Polygon> convex;
        for (int k = *rc::gen::inRange(0, 9); k > 0; --k) {
            Polygon hull = randomConvex();
            if (hull.size() >= 3 && signedArea(hull) > 1e-3) convex.push_back(std::move(hull));
        }
        const auto parts = freeArea(kBox, convex);
        for (int i = 0; i < 40; ++i)
            for (int j = 0; j < 24; ++j) {
                const Vec2 p{0.25 * i + 0.1234567, 0.25 * j + 0.0987654};
                double nearest = 1e9;
                for (const Polygon& polygon : convex) nearest = std::min(nearest, signedDistance(polygon, p));
                if (std::abs(nearest) < 1e-6) continue;
                RC_ASSERT(isFree(parts, p) == (nearest > 0.0));
            }
    }));
}
