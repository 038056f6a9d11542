#include "people/motion/patch_crossing.h"
#include "base/maths.h"

#include <doctest.h>
#include <rapidcheck.h>

#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// An environment with one patch, number 1.
Environment with(const Polygon& polygon, bool moving = false) {
    Environment environment = Environment::create({}).value();
    PatchDef patch{.polygon = polygon, .motion = 5};
    if (moving) patch.path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {5, 0}, 0.0}};
    REQUIRE(environment.addPatch(patch).ok());
    environment.setTime(0.0);
    return environment;
}

const Polygon kWall{{-0.6, -5}, {0.6, -5}, {0.6, 5}, {-0.6, 5}};

Vec2 facing(double degrees) {
    return {cosine(degrees * kPi / 180.0), sine(degrees * kPi / 180.0)};
}

}  // namespace

TEST_CASE("a wall is crossed at right angles, from one face to the other") {
    const Environment environment = with(kWall);
    for (const double degrees : {-40.0, -10.0, 0.0, 25.0, 49.0}) {
        const PatchCrossing path = crossPatch(environment, 1, {-0.59, 1.0}, facing(degrees), 1.2);
        CHECK(path.normal.x == doctest::Approx(1.0));
        CHECK(path.begin == doctest::Approx(-0.6));
        CHECK(path.length == doctest::Approx(1.2));
        CHECK(!path.timed);
    }
    const PatchCrossing back = crossPatch(environment, 1, {0.59, 1.0}, {-1.0, 0.0}, 1.2);
    CHECK(back.normal.x == doctest::Approx(-1.0));
    CHECK(back.begin == doctest::Approx(-0.6));
}

TEST_CASE("along a wall one goes straight on") {
    const PatchCrossing path = crossPatch(with(kWall), 1, {-0.59, 1.0}, facing(80.0), 1.2);
    CHECK(path.normal.y == doctest::Approx(facing(80.0).y));
}

TEST_CASE("a clip fills what suits it, lies in the middle of longer patches, goes on beyond shorter ones") {
    const auto across = [](double half, double clip) {
        const Polygon polygon{{-half, -5}, {half, -5}, {half, 5}, {-half, 5}};
        return crossPatch(with(polygon), 1, {-half + 0.01, 0.0}, {1.0, 0.0}, clip);
    };
    CHECK(across(0.525, 1.2).length == doctest::Approx(1.05));
    const PatchCrossing longer = across(3.0, 2.0);
    CHECK(longer.length == doctest::Approx(2.3));
    CHECK(longer.begin == doctest::Approx(-1.15));
    const PatchCrossing shorter = across(0.25, 2.0);
    CHECK(shorter.length == doctest::Approx(1.7));
    CHECK(shorter.begin == doctest::Approx(-0.25));
}

TEST_CASE("a moving patch is crossed by time") {
    CHECK(crossPatch(with(kWall, true), 1, {-0.6, 0.0}, {1, 0}, 1.2).timed);
}

TEST_CASE("what is behind never falls, and lies between 0 and 1") {
    CHECK(rc::check("share", [] {
        PatchCrossing path{.length = 2.0};
        double before = 0.0;
        Vec2 at{0.01, 0.0};
        for (int k = 0; k < 100; ++k) {
            at.x += static_cast<double>(*rc::gen::inRange(-60, 90)) * 0.001;
            const double share = shareCrossed(path, at);
            if (share < 0.0) continue;
            RC_ASSERT(share >= before);
            RC_ASSERT(share <= 1.0);
            before = share;
        }
    }));
}

TEST_CASE("time follows the way where a clip goes unevenly") {
    SwingDef def{.cyclic = false};
    Clip clip = swingingClip(def);
    const auto last = static_cast<float>(clip.travel.size() - 1);
    for (std::size_t f = 0; f < clip.travel.size(); ++f) {
        const float t = static_cast<float>(f) / last;
        clip.travel[f].x = 2.0f * t * t;  // Slow at first.
    }
    const TravelTimes way(clip);
    CHECK(way.time(0.0f) == doctest::Approx(0.0));
    CHECK(way.time(1.0f) == doctest::Approx(clip.duration()));
    // 0.9 t^2 + 0.1 t = 0.25 at t = 0.4744.
    CHECK(way.time(0.25f) == doctest::Approx(0.4744 * clip.duration()).epsilon(0.01));
    float before = -1.0f;
    for (float share = 0.0f; share <= 1.0f; share += 0.01f) {
        CHECK(way.time(share) > before);
        before = way.time(share);
    }
}
