#include "people/clips/hips_path.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "base/maths.h"

using namespace muster;

TEST_CASE("an even way round a curve is an arc from end to end") {
    rc::check("arcs", [] {
        const double turn = *rc::gen::inRange(-25, 26) / 10.0, radius = 2.0,
                     begin = *rc::gen::inRange(-30, 31) / 10.0;
        RC_PRE(std::fabs(turn) > 0.4);
        std::vector<HipsAt> hips;
        const double side = turn > 0 ? 1.0 : -1.0;
        for (int i = 0; i <= 40; ++i) {
            const double facing = begin + turn * i / 40.0;
            // On a circle to the left or right.
            hips.push_back({radius * side * sine(facing), -radius * side * cosine(facing), facing});
        }
        std::vector<Travel> travel = evenTravel(hips);
        for (std::size_t i = 0; i < travel.size(); ++i) {
            RC_ASSERT(std::fabs(travel[i].x - hips[i].x) < 1e-4);
            RC_ASSERT(std::fabs(travel[i].y - hips[i].y) < 1e-4);
            RC_ASSERT(std::fabs(travel[i].yaw - hips[i].facing) < 1e-4);
        }
        fromStart(travel);
        RC_ASSERT(std::fabs(travel.back().yaw - turn) < 1e-4);
        RC_ASSERT(std::fabs(travel.back().x - radius * std::fabs(sine(turn))) < 1e-3 ||
                  std::fabs(turn) > kPi / 2);
    });
}

TEST_CASE("a way all round a circle is as long as the circle") {
    for (const double turn : {2.0 * kPi, -2.0 * kPi, 1.98 * kPi, 2.05 * kPi}) {
        const double side = turn > 0.0 ? 1.0 : -1.0;
        std::vector<HipsAt> hips;
        for (int i = 0; i <= 200; ++i) {
            const double facing = turn * i / 200.0;
            hips.push_back({1.5 * side * sine(facing), 1.5 - 1.5 * side * cosine(facing), facing});
        }
        const std::vector<Travel> travel = evenTravel(hips);
        double way = 0.0;
        for (std::size_t i = 1; i < travel.size(); ++i)
            way += std::hypot(travel[i].x - travel[i - 1].x, travel[i].y - travel[i - 1].y);
        CHECK(way == doctest::Approx(1.5 * std::fabs(turn)).epsilon(0.01));
        // Nor does who turns on the spot go anywhere, whatever its hips sway by.
        for (HipsAt& at : hips) at = {0.01 * sine(3.0 * at.facing), 0.0, at.facing};
        hips.back().x = 0.02;
        for (const Travel& at : evenTravel(hips)) CHECK(std::hypot(at.x, at.y) < 0.3);
    }
}

TEST_CASE("a smoothed way keeps its ends and a straight even way as it is") {
    std::vector<HipsAt> hips;
    for (int i = 0; i < 50; ++i) hips.push_back({0.1 * i, 0.0, 0.3});
    const auto straight = smoothTravel(hips, 60.0, 0.5);
    for (int i = 0; i < 50; ++i) CHECK(straight[i].x == doctest::Approx(0.1 * i));
    for (int i = 0; i < 50; ++i) hips[i].y = i % 2 ? 0.02 : -0.02;
    const auto calm = smoothTravel(hips, 60.0, 0.5);
    CHECK(calm.front().y == doctest::Approx(-0.02));
    CHECK(calm.back().y == doctest::Approx(0.02));
    for (std::size_t i = 16; i < 34; ++i) CHECK(std::fabs(calm[i].y) < 0.002f);
}
