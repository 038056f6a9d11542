// Reachable targets from step to step, as a PlaceTracker updates them.
#include "engine/formation/places/target_update.h"

#include "engine/formation/place_scene.h"

using namespace muster;
using namespace muster::test;

TEST_CASE(
    "reachable targets in a gap stay separated and free, move continuously, and do not depend on the "
    "threads") {
    Environment environment = emptyWorld(40.0);
    REQUIRE(environment.addObstacle(box({-3, 4}, {3, 40})).ok());
    REQUIRE(environment.addObstacle(box({-3, -40}, {3, -4})).ok());
    environment.setTime(0.0);
    const std::int32_t region = routes(environment).region({-10, 0});
    std::vector<Vec2> targets;
    const auto aim = [&](double x) {
        targets.clear();
        for (int k = 0; k < 600; ++k) targets.push_back({x + k % 25 - 12.0, k / 25 - 12.0});
    };
    ThreadPool pool(3);
    PlaceDef def;
    PlaceTracker places, threaded;
    aim(-16.0);
    places.reset(def, targets, routes(environment), region);
    threaded.reset(def, targets, routes(environment), region);
    CHECK(places.reachableTargets() == targets);
    std::size_t jumps = 0, moves = 0, unfit = 0, displaced = 0;
    for (int k = 0; k < 1500; ++k) {
        aim(std::min(-16.0 + 1.4 * k * kStep, 18.0));
        const std::vector<Vec2> before = places.reachableTargets();
        places.advance(def, targets, routes(environment), region, kStep);
        threaded.advance(def, targets, routes(environment), region, kStep, &pool);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const Vec2 point = places.reachableTargets()[i];
            if (places.fit()[i] == 0) ++unfit;
            if (places.fit()[i] == 0) continue;
            REQUIRE(environment.distanceToObstacle(point) > def.radius);
            displaced += point == targets[i] ? 0 : 1;
            jumps += distance(point, before[i]) > 0.15 ? 1 : 0;
            ++moves;
        }
        if (k % 50 != 0) continue;
        CHECK(hashOf(places) == hashOf(threaded));
        double least = 1.0;
        for (std::size_t i = 0; i < targets.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (places.fit()[i] != 0 && places.fit()[j] != 0)
                    least = std::min(least,
                                     distance(places.reachableTargets()[i], places.reachableTargets()[j]));
        CHECK(least >= 2 * def.radius * (1 - 1e-8));
    }
    MESSAGE("of " << moves << " moves of reachable targets " << jumps << " were jumps, " << displaced
                  << " off their targets; unfit " << unfit);
    CHECK(displaced > moves / 20);  // The gap was narrow.
    CHECK(jumps < moves / 200);
    CHECK(unfit < moves / 20);
    CHECK(places.reachableTargets() == targets);  // Behind the gap all are on their targets.
}

TEST_CASE("a place that loses its point finds another in the same step where there is free space") {
    Environment environment = emptyWorld(24.0);
    REQUIRE(environment.addObstacle(box({-3, -3}, {3, 3})).ok());
    environment.setTime(0.0);
    PlaceTracker places;
    std::vector<Vec2> targets;
    for (int k = 0; k < 400; ++k) targets.push_back({-18.0 + k % 20 * 0.6, -6.0 + k / 20 * 0.6});
    places.reset({}, targets, routes(environment), -1);
    int without = 0;
    for (int step = 0; step < 900; ++step) {
        // Over the block and back, rotating all the time.
        const double shift = step < 450 ? 0.03 : -0.03;
        const Vec2 middle = targets[210];
        for (Vec2& t : targets) t = middle + Vec2{shift, 0.0} + Rotation{0.99998, 0.0063}.apply(t - middle);
        places.advance({}, targets, routes(environment), -1, kStep);
        without += static_cast<int>(std::count(places.fit().begin(), places.fit().end(), std::uint8_t{0}));
    }
    CAPTURE(without);
    // Of 360,000; a few find all points near them occupied and wait for a step or two.
    CHECK(without < 40);
}

TEST_CASE("a target that jumps takes its place along; the other places keep their points") {
    Environment environment = emptyWorld();
    environment.setTime(0.0);
    std::vector<Vec2> targets;
    for (int k = 0; k < 30; ++k) targets.push_back({k % 6 * 1.0, k / 6 * 1.0});
    targets[7] = targets[8];  // Two targets coincide: one of them gets a point beside it.
    PlaceTracker places;
    places.reset({}, targets, routes(environment), -1);
    for (int k = 0; k < 30; ++k) places.advance({}, targets, routes(environment), -1, kStep);
    const std::vector<Vec2> before = places.reachableTargets();
    targets[20] = {-8, -8};
    places.advance({}, targets, routes(environment), -1, kStep);
    CHECK(places.reachableTargets()[20] == targets[20]);
    for (std::size_t i = 0; i < 30; ++i)
        if (i != 20) CHECK(distance(places.reachableTargets()[i], before[i]) <= 0.15);
    for (int k = 0; k < 600; ++k) places.advance({}, targets, routes(environment), -1, kStep);
    CHECK(std::count(places.fit().begin(), places.fit().end(), 1) == 30);
    CHECK(closestPair(places) >= 0.5 * (1 - 1e-8));
    CHECK(distance(places.positions()[20], targets[20]) < 1e-9);
}
