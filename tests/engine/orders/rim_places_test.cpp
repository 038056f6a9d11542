// Places round a rectangle: on its rims, even, and never too near to each other.
#include "engine/orders/rim_places.h"

#include <doctest.h>

using namespace muster;

TEST_CASE("places lie on rims, and apart from each other") {
    for (const Vec2 half : {Vec2{4, 3}, Vec2{0, 0}, Vec2{10, 0}, Vec2{1, 1}})
        for (const int count : {2, 7, 40, 120}) {
            const auto places = rimPlaces(count, half, 0.6);
            REQUIRE(static_cast<int>(places.size()) == count);
            double nearest = 1e9;
            for (std::size_t a = 0; a < places.size(); ++a) {
                // The distance to the rectangle is a whole number of steps between rims.
                const double out = std::max(std::fabs(places[a].x) - std::max(half.x, 0.45),
                                            std::fabs(places[a].y) - std::max(half.y, 0.45));
                const double ring = out / 0.66;
                CHECK(std::fabs(ring - std::round(ring)) < 1e-9);
                for (std::size_t b = a + 1; b < places.size(); ++b)
                    nearest = std::min(nearest, distance(places[a], places[b]));
            }
            CAPTURE(count);
            CHECK(nearest >= 0.6);
        }
}

TEST_CASE("few places are even on the rim") {
    const auto places = rimPlaces(14, {4, 3}, 0.6);
    CHECK(distance(places[0], {4, 0}) < 1e-12);
    CHECK(distance(places[1], {4, 2}) < 1e-12);
    CHECK(distance(places[2], {3, 3}) < 1e-12);
}
