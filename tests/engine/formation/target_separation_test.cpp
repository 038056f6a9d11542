#include "engine/formation/places/target_separation.h"

#include <doctest.h>

#include <algorithm>

#include "base/random.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

constexpr double kSeparation = 0.5;

double closestFitPair(const std::vector<Vec2>& targets, const std::vector<std::uint8_t>& fit) {
    double least = 1e300;
    for (std::size_t a = 0; a < targets.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (fit[a] != 0 && fit[b] != 0) least = std::min(least, distance(targets[a], targets[b]));
    return least;
}

}  // namespace

TEST_CASE("separated targets lie in the free space and are separated, whatever they were") {
    Random random(4);
    SeparationMemory memory;
    for (int round = 0; round < 10; ++round) {
        Environment environment = emptyWorld(20.0, 0.25);
        for (int k = 0; k < 8; ++k) REQUIRE(environment.addObstacle(randomObstacle(random, 9.0, false)).ok());
        const PlaceDef def;
        RouteGraph routes;
        routes.update(environment, def.radius);
        NearestReachable nearest;
        const FreeSpace space(def, routes, -1, nearest);
        std::vector<Vec2> targets(200);
        const double size = round % 2 == 0 ? 9.0 : 2.0;
        for (Vec2& p : targets) p = {random.uniform(-size, size), random.uniform(-size, size)};
        targets[7] = targets[8];
        std::vector<std::uint8_t> fit;
        separateTargets(space, kSeparation, targets, fit, memory);
        REQUIRE(fit.size() == targets.size());
        CHECK(closestFitPair(targets, fit) >= kSeparation * (1.0 - 1e-8));
        for (std::size_t k = 0; k < targets.size(); ++k)
            if (fit[k] != 0) CHECK(environment.distanceToObstacle(targets[k]) >= def.radius - 1e-6);
        CHECK(std::count(fit.begin(), fit.end(), 1) > 190);
    }
}

TEST_CASE("targets that are separated and free stay where they are, bit for bit") {
    Environment environment = emptyWorld(20.0, 0.25);
    const PlaceDef def;
    std::vector<Vec2> targets;
    for (int k = 0; k < 100; ++k) targets.push_back({k % 10 * kSeparation, k / 10 * kSeparation});
    const std::vector<Vec2> before = targets;
    std::vector<std::uint8_t> fit;
    SeparationMemory memory;
    RouteGraph routes;
    routes.update(environment, def.radius);
    NearestReachable nearest;
    separateTargets(FreeSpace(def, routes, -1, nearest), kSeparation, targets, fit, memory);
    CHECK(targets == before);
    CHECK(std::count(fit.begin(), fit.end(), 1) == 100);
}

TEST_CASE("of too many targets for the free space, those of lower index are fit first") {
    Environment environment = emptyWorld(2.0, 0.25);
    const PlaceDef def;
    std::vector<Vec2> targets(60);
    std::vector<std::uint8_t> fit;
    SeparationMemory memory;
    RouteGraph routes;
    routes.update(environment, def.radius);
    NearestReachable nearest;
    separateTargets(FreeSpace(def, routes, -1, nearest), kSeparation, targets, fit, memory);
    CHECK(fit[0] == 1);
    const auto count = std::count(fit.begin(), fit.end(), 1);
    CHECK(count >= 4);
    CHECK(count <= 18);
    CHECK(closestFitPair(targets, fit) >= kSeparation * (1.0 - 1e-8));
}
