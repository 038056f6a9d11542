// Regions: areas, points, parts round a point, well-known text.
#include "lab/measures/region.h"

#include <doctest.h>

#include "engine/geometry/polygon.h"

using namespace muster;

namespace {

Region regionOf(const char* text) {
    auto region = Region::parse(text);
    REQUIRE_MESSAGE(region.ok(), region.status().message());
    return std::move(region).value();
}

Polygon squareAt(Vec2 low, double size) {
    return {low, {low.x + size, low.y}, {low.x + size, low.y + size}, {low.x, low.y + size}};
}

double areaOfPieces(const std::vector<Polygon>& pieces) {
    double sum = 0.0;
    for (const Polygon& piece : pieces) sum += signedArea(piece);
    return sum;
}

}  // namespace

TEST_CASE("areas and points of a region with a hole and of two parts") {
    const Region one = regionOf("POLYGON ((0 0, 10 0, 10 6, 0 6, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2))");
    CHECK(one.area() == doctest::Approx(56.0));
    CHECK(one.contains({1, 1}));
    CHECK_FALSE(one.contains({3, 3}));
    CHECK_FALSE(one.contains({11, 3}));
    const Region two = regionOf("MULTIPOLYGON(((0 0,2 0,1 2,0 0)),((5 0,6 0,6 1,5 1,5 0)))");
    CHECK(two.area() == doctest::Approx(3.0));
    CHECK(two.contains({1, 1}));
    CHECK_FALSE(two.contains({3, 0.5}));
    CHECK(two.contains({5.5, 0.5}));
    CHECK(regionOf("GEOMETRYCOLLECTION(POLYGON((0 0,1 0,1 1,0 0)))").area() == doctest::Approx(0.5));
    for (const char* bad : {"", "POINT (0 0)", "POLYGON (0 0, 1 1)", "POLYGON ((0 0, 1 x, 1 1))",
                            "POLYGON ((0 0, 1 0))", "POLYGON ((0 0, 1 0, 1 1)) and more"})
        CHECK_FALSE(Region::parse(bad).ok());
}

TEST_CASE("what a convex polygon shares with a region") {
    const Region region = regionOf("POLYGON ((0 0, 10 0, 10 6, 0 6, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2))");
    CHECK(region.sharedArea(squareAt({1, 1}, 2)) == doctest::Approx(3.0));
    CHECK(region.sharedArea(squareAt({-5, -5}, 30)) == doctest::Approx(56.0));
    CHECK(region.sharedArea(squareAt({2.5, 2.5}, 1)) == doctest::Approx(0.0));
}

TEST_CASE("a thin wall parts what lies on its sides") {
    const Region region = regionOf("POLYGON ((0 0, 10 0, 10 4, 5.1 4, 5.1 1, 5 1, 5 4, 0 4, 0 0))");
    // The square reaches round neither end of the wall: only the left side hangs together with the point.
    const Polygon square = squareAt({4, 2}, 2);
    CHECK(areaOfPieces(region.partAround(square, {4.5, 3})) == doctest::Approx(2.0));
    CHECK(areaOfPieces(region.partAround(square, {5.5, 3})) == doctest::Approx(1.8));
    // This one reaches below it: both sides belong together.
    CHECK(areaOfPieces(region.partAround(squareAt({4, 0.5}, 2), {4.5, 2})) == doctest::Approx(4.0 - 0.15));
    CHECK(region.partAround(square, {5.05, 3}).empty());
}

TEST_CASE("areas by trapezoids are those by counting points") {
    const Region region = regionOf(
        "POLYGON ((0 0, 6 1, 9 0, 8 5, 6 3.5, 4 6, 3 3, 0 5, 0 0), (5 2, 6 2.2, 5.6 3, 4.8 2.8, 5 2))");
    const Polygon convex{{1, 0.5}, {7, 0.2}, {8, 3}, {4, 5}, {1.5, 3}};
    std::size_t inside = 0, all = 0;
    constexpr int kLines = 900;
    for (int i = 0; i < kLines; ++i)
        for (int k = 0; k < kLines; ++k) {
            const Vec2 p{9.0 * (i + 0.5) / kLines, 6.0 * (k + 0.5) / kLines};
            ++all;
            if (region.contains(p) && containsPoint(convex, p)) ++inside;
        }
    const double counted = 54.0 * static_cast<double>(inside) / static_cast<double>(all);
    CHECK(region.sharedArea(convex) == doctest::Approx(counted).epsilon(0.002));
}

TEST_CASE("ground outside of obstacles") {
    const std::vector<Polygon> obstacles{squareAt({2, 2}, 1), squareAt({2.5, 2}, 1)};
    const auto ground = regionOutside({{0, 0}, {10, 10}}, obstacles);
    REQUIRE(ground.ok());
    CHECK(ground->area() == doctest::Approx(98.5));
}
