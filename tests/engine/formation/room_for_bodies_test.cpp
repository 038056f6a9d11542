#include "engine/formation/places/room_for_bodies.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

namespace muster {
namespace {

std::vector<Vec2> lattice(std::int32_t side, double spacing) {
    std::vector<Vec2> places;
    for (std::int32_t y = 0; y < side; ++y)
        for (std::int32_t x = 0; x < side; ++x)
            places.push_back(Vec2{x - 0.5 * (side - 1), y - 0.5 * (side - 1)} * spacing);
    return places;
}

// By all pairs: how far a pair is from having room, at worst [m].
double worstLack(const std::vector<Vec2>& places, const std::vector<double>& radii, double least) {
    double worst = 0.0;
    for (std::size_t a = 0; a < places.size(); ++a)
        for (std::size_t b = a + 1; b < places.size(); ++b)
            worst = std::max(worst, std::max(least, radii[a] + radii[b]) - distance(places[a], places[b]));
    return worst;
}

}  // namespace

TEST_SUITE("room_for_bodies") {
    TEST_CASE("places with room stay, to the last bit") {
        std::vector<Vec2> places = lattice(7, 3.0);
        const std::vector<Vec2> before = places;
        std::vector<double> radii(places.size(), 0.25);
        radii[10] = 1.4;
        RoomForBodies().make(radii, 0.5, places);
        CHECK(places == before);
    }

    TEST_CASE("one large body pushes rings away and keeps their areas") {
        std::vector<Vec2> places = lattice(15, 1.0);
        const std::vector<Vec2> before = places;
        const std::size_t middle = places.size() / 2;
        std::vector<double> radii(places.size(), 0.25);
        radii[middle] = 1.5;
        RoomForBodies().make(radii, 0.5, places);
        CHECK(worstLack(places, radii, 0.5) < 1e-3);
        CHECK(places[middle] == before[middle]);
        // The area between two circles of places stays: pi (R^2 - r^2), whatever was put into the middle.
        const double inner = lengthSquared(places[middle + 3]) - lengthSquared(before[middle + 3]);
        const double outer = lengthSquared(places[middle + 7]) - lengthSquared(before[middle + 7]);
        CHECK(inner == doctest::Approx(outer).epsilon(1e-6));
        CHECK(std::sqrt(inner + 1.0) == doctest::Approx(1.79).epsilon(1e-6));
    }

    TEST_CASE("few, many and all bodies large, on lattices and scattered") {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            CAPTURE(seed);
            Random random(seed);
            std::vector<Vec2> places = lattice(12, 0.8 + 0.05 * static_cast<double>(seed));
            for (Vec2& place : places) place += Vec2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
            std::vector<double> radii(places.size(), 0.25);
            for (double& radius : radii)
                if (random.uniform(0.0, 1.0) < 0.05 * static_cast<double>(seed))
                    radius = random.uniform(0.5, 1.2);
            std::vector<Vec2> again = places;
            RoomForBodies room;
            room.make(radii, 0.5, places);
            CHECK(worstLack(places, radii, 0.5) < 0.05);
            room.make(radii, 0.5, again);
            CHECK(again == places);
        }
    }

    TEST_CASE("a block of large bodies among a thousand") {
        std::vector<Vec2> places = lattice(32, 1.0);
        std::vector<double> radii(places.size(), 0.25);
        std::fill(radii.begin(), radii.begin() + 320, 0.8);
        RoomForBodies().make(radii, 1.0, places);
        CHECK(worstLack(places, radii, 0.5) < 0.1);
    }

    TEST_CASE("places on one point, one place, and none") {
        std::vector<Vec2> places(3, Vec2{1.0, 2.0});
        const std::vector<double> radii{0.25, 1.0, 0.25};
        RoomForBodies().make(radii, 0.5, places);
        CHECK(worstLack(places, radii, 0.5) < 1e-3);
        std::vector<Vec2> one{{1.0, 2.0}}, none;
        RoomForBodies().make(std::vector<double>{2.0}, 0.5, one);
        RoomForBodies().make({}, 0.5, none);
        CHECK(one[0] == Vec2{1.0, 2.0});
    }
}

}  // namespace muster
