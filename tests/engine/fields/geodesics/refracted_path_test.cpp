// Refracted paths over ground of two unit costs, against the law of refraction.
#include "engine/fields/geodesics/one_vertex_paths.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/fields/cost/ground_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

// Cost of the cheapest path from x < 0 with unit cost 1 to x > 0 with unit cost `unit`, by sampling the
// border x = 0.
double refracted(Vec2 a, Vec2 b, double unit) {
    double best = 1e300;
    const double low = std::min(a.y, b.y) - 1.0;
    const double high = std::max(a.y, b.y) + 1.0;
    for (double y = low; y <= high; y += 0.002)
        best = std::min(best, distance(a, {0.0, y}) + unit * distance({0.0, y}, b));
    return best;
}

}  // namespace

TEST_CASE("paths into slow ground are refracted at its border") {
    Environment environment = squareWorld(16.0);
    REQUIRE(environment.addPatch(slowBox(0.0, -16.0, 16.0, 16.0, 0.25)).ok());
    const StaticGround ground = groundOf(environment);
    Random random(5);
    double error = 0.0;
    double straightError = 0.0;
    double total = 0.0;
    for (int k = 0; k < 600; ++k) {
        const Vec2 a{random.uniform(-3.0, -0.1), random.uniform(-3, 3)};
        const Vec2 b{random.uniform(0.1, 3.0), random.uniform(-3, 3)};
        const double exact = refracted(a, b, 4.0);
        const RefractedPath path = refractedPath(ground, a, b);
        // Cells locate the border to within half a cell.
        REQUIRE(path.cost > exact - 0.5);
        error += std::fabs(path.cost - exact);
        straightError += std::fabs(ground.lineCost(a, b) - exact);
        total += exact;
        // The path back costs the same.
        REQUIRE(refractedPath(ground, b, a).cost == doctest::Approx(path.cost).epsilon(0.08));
    }
    CAPTURE(error / total);
    CAPTURE(straightError / total);
    CHECK(error < 0.04 * total);
    CHECK(error < 0.4 * straightError);
}

TEST_CASE("on uniform ground the path is the straight line") {
    Environment environment = squareWorld(16.0);
    REQUIRE(environment.addPatch(slowBox(0.0, -16.0, 16.0, 16.0, 0.25)).ok());
    const StaticGround ground = groundOf(environment);
    const RefractedPath fast = refractedPath(ground, {-5, -2}, {-1, 1});
    CHECK(fast.cost == doctest::Approx(5.0));
    CHECK(fast.firstVertex == Vec2{-1, 1});
    const RefractedPath slow = refractedPath(ground, {5, -2}, {1, 1});
    CHECK(slow.cost == doctest::Approx(20.0));
    CHECK(slow.firstVertex == Vec2{1, 1});
}

TEST_CASE("no refracted path leads through a wall") {
    Environment environment = squareWorld(16.0);
    // The slow corridor lies between walls.
    REQUIRE(environment.addPatch(slowBox(0.0, -1.0, 8.0, 1.0, 0.2)).ok());
    REQUIRE(environment.addObstacle(rectangle(-4, 1, 12, 2)).ok());
    REQUIRE(environment.addObstacle(rectangle(-4, -2, 12, -1)).ok());
    const StaticGround ground = groundOf(environment);
    CHECK(ground.collisionFree({-3, 0}, {6, 0}));
    CHECK_FALSE(ground.lineOfSight({-3, 0}, {6, 0}));
    CHECK_FALSE(ground.collisionFree({-3, 0}, {-3, 3}));
    CHECK(refractedPath(ground, {-3, 0}, {6, 0}).cost > 3.0 + 5.0 * 6.0 - 1.5);
}

TEST_CASE("collision-free lines are those without a wall, whatever the ground costs") {
    Environment bare = squareWorld(16.0);
    Environment patched = squareWorld(16.0);
    Random random(5);
    for (int k = 0; k < 25; ++k) {
        ObstacleDef tree{.centre = {random.uniform(-13, 13), random.uniform(-13, 13)},
                         .radius = random.uniform(0.3, 1.2)};
        REQUIRE(bare.addObstacle(tree).ok());
        REQUIRE(patched.addObstacle(tree).ok());
    }
    REQUIRE(patched.addPatch(slowBox(-8, -9, 3, 6, 0.3)).ok());
    const StaticGround without = groundOf(bare);
    const StaticGround with = groundOf(patched);
    int clear = 0;
    for (int k = 0; k < 3000; ++k) {
        const Vec2 a = freeSpot(bare, random, 14.0);
        const Vec2 b = a + Vec2{random.uniform(-6, 6), random.uniform(-6, 6)};
        REQUIRE(with.collisionFree(a, b) == without.lineOfSight(a, b));
        clear += with.collisionFree(a, b) ? 1 : 0;
    }
    CHECK(clear > 500);
    CHECK(clear < 2500);
}
