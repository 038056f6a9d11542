#include "engine/formation/places/place_tracker.h"

#include <chrono>

#include "engine/formation/place_scene.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("in the open places are exactly on their targets while these move slowly") {
    Environment environment = emptyWorld();
    environment.setTime(0.0);
    std::vector<Vec2> targets{{0, 0}, {1, 0}, {0, 1}};
    PlaceTracker places;
    places.reset({}, targets, routes(environment), -1);
    CHECK(places.positions() == targets);
    for (int k = 0; k < 100; ++k) {
        for (Vec2& t : targets) t += Vec2{0.02, 0.01};
        places.advance({}, targets, routes(environment), -1, kStep);
        CHECK(places.positions() == targets);
        CHECK(distance(places.velocities()[1], {1.2, 0.6}) < 1e-9);
    }
}

TEST_CASE("fast targets are followed at bounded speed, slower on slow ground") {
    Environment environment = emptyWorld();
    REQUIRE(environment.addPatch({.polygon = {{2, -5}, {6, -5}, {6, 5}, {2, 5}}, .speed = 0.5}).ok());
    environment.setTime(0.0);
    PlaceTracker places;
    places.reset({}, std::vector<Vec2>{{0, 0}}, routes(environment), -1);
    const std::vector<Vec2> target{{8, 0}};
    Vec2 last = places.positions()[0];
    int steps = 0;
    while (distance(places.positions()[0], target[0]) > 0 && ++steps < 2000) {
        places.advance({}, target, routes(environment), -1, kStep);
        const double speed = distance(last, places.positions()[0]) / kStep;
        CHECK(speed <= (last.x > 2.3 && last.x < 5.7 ? 1.0 : 2.0) + 1e-9);
        last = places.positions()[0];
    }
    // 4 m at 2 m/s and 4 m (whole cells) at 1 m/s.
    CHECK(steps * kStep == doctest::Approx(6.0).epsilon(0.05));
}

TEST_CASE("targets in obstacles get points of the free space, a diameter apart") {
    Environment environment = emptyWorld();
    REQUIRE(environment.addObstacle(box({-2, -2}, {2, 2})).ok());
    environment.setTime(0.0);
    std::vector<Vec2> targets;
    for (int k = 0; k < 36; ++k) targets.push_back({k % 6 * 0.9 - 2.25, k / 6 * 0.9 - 2.25});
    PlaceDef def;
    PlaceTracker places;
    places.reset(def, targets, routes(environment), -1);
    int fit = 0;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        CHECK(environment.distanceToObstacle(places.positions()[k]) > def.radius - 1e-6);
        fit += places.fit()[k];
    }
    CHECK(fit == 36);
    CHECK(closestPair(places) >= 2 * def.radius * (1 - 1e-8));
}

TEST_CASE("coincident targets are separated; those without free space are unfit") {
    Environment environment = emptyWorld(1.0);
    environment.setTime(0.0);
    const std::vector<Vec2> targets(60, Vec2{0, 0});
    PlaceTracker places;
    places.reset({}, targets, routes(environment), -1);
    const auto fit = std::count(places.fit().begin(), places.fit().end(), 1);
    // A square of 2 m holds at most a dense packing of discs of 0.5 m.
    CHECK(fit >= 4);
    CHECK(fit <= 18);
    CHECK(closestPair(places) >= 0.5 * (1 - 1e-8));
}

TEST_CASE("a place goes round a wall to a target on the other side") {
    Environment environment = emptyWorld();
    REQUIRE(environment.addObstacle(box({-0.5, -6}, {0.5, 6})).ok());
    environment.setTime(0.0);
    PlaceDef def;
    PlaceTracker places;
    places.reset(def, std::vector<Vec2>{{-2, 0}}, routes(environment), -1);
    double travelled = 0.0;
    int steps = 0;
    while (distance(places.positions()[0], {2, 0}) > 1e-9 && ++steps < 3000) {
        const Vec2 before = places.positions()[0];
        places.advance(def, std::vector<Vec2>{{2, 0}}, routes(environment), -1, kStep);
        REQUIRE(environment.distanceToObstacle(places.positions()[0]) > def.radius - 2e-3);
        travelled += distance(before, places.positions()[0]);
    }
    // The shortest path: two tangents to the discs about an end's corners, the arcs on these and the wall's
    // width.
    const double radius = def.radius;
    const double hyp = std::hypot(1.5, 6.0);
    // Each arc leads from the tangent's direction to that along the wall's end.
    const double arc = radius * (std::atan2(6.0, 1.5) + std::asin(radius / hyp));
    const double shortest = 2 * (std::sqrt(hyp * hyp - radius * radius) + arc) + 1.0;
    CHECK(steps < 3000);
    CHECK(travelled > shortest * (1 - 1e-3));
    CHECK(travelled < 1.06 * shortest);
}

TEST_CASE("where an obstacle protrudes into the path between free cells a place slides along it") {
    // The cells (2.875, 2.125) and (3.125, 2.125) are free, the line between them comes within 0.245 m of the
    // trunk.
    for (const double trunk : {1.63, 1.64, 1.65, 1.66}) {
        Environment environment = emptyWorld();
        REQUIRE(environment.addObstacle({.centre = {2.98, trunk}, .radius = 0.25}).ok());
        environment.setTime(0.0);
        PlaceTracker places;
        places.reset({}, std::vector<Vec2>{{2.5, 2.04}}, routes(environment), -1);
        const std::vector<Vec2> target{{6.0, 0.9}};
        Vec2 last = places.positions()[0];
        for (int k = 0; k < 240; ++k) {
            places.advance({}, target, routes(environment), -1, kStep);
            const Vec2 now = places.positions()[0];
            CHECK(distance(now, last) <= 2.0 * kStep + 1e-9);
            CHECK(environment.distanceToObstacle(now) > 0.247);
            last = now;
        }
        CHECK(distance(last, target[0]) < 1e-9);
    }
}

TEST_CASE("places stay in the region of their group") {
    Environment environment = emptyWorld(8.0);
    REQUIRE(environment.addObstacle(box({-0.5, -8}, {0.5, 8})).ok());
    environment.setTime(0.0);
    const std::int32_t left = routes(environment).region({-4, 0});
    REQUIRE(left >= 0);
    REQUIRE(left != routes(environment).region({4, 0}));
    PlaceTracker places;
    places.reset({}, std::vector<Vec2>{{-4, 0}, {4, 0}, {3, 3}}, routes(environment), left);
    for (int k = 0; k < 300; ++k)
        places.advance({}, std::vector<Vec2>{{4, 0}, {5, 1}, {7, -3}}, routes(environment), left, kStep);
    for (const Vec2 p : places.positions()) CHECK(routes(environment).region(p) == left);
}

TEST_CASE("the number of targets may change, and targets that are not finite are replaced") {
    Environment environment = emptyWorld();
    environment.setTime(0.0);
    PlaceTracker places;
    places.advance({}, std::vector<Vec2>{{1, 1}}, routes(environment), -1, kStep);
    CHECK(places.positions().size() == 1);
    places.advance({}, std::vector<Vec2>{{1, 1}, {3, 3}, {std::nan(""), 2}}, routes(environment), -1, kStep);
    CHECK(places.positions()[1] == Vec2{3, 3});
    CHECK(isFinite(places.positions()[2]));
    CHECK(places.velocities().size() == 3);
    places.advance({}, {}, routes(environment), -1, kStep);
    CHECK(places.positions().empty());
    places.advance({}, std::vector<Vec2>{{100, 0}}, routes(environment), -1, kStep);
    CHECK(environment.def().box.contains(places.positions()[0]));
}

TEST_CASE(
    "random scenes: no place crosses an obstacle or exceeds the speed bound, and fit places are separated") {
    Random random(2024);
    int arrived = 0, all = 0;
    for (int scene = 0; scene < 12; ++scene) {
        Environment environment = emptyWorld(12.0);
        std::vector<ObstacleDef> obstacles;
        for (int k = 0; k < 7; ++k) {
            const Vec2 corner{random.uniform(-9, 7), random.uniform(-9, 7)};
            obstacles.push_back(
                box(corner, corner + Vec2{random.uniform(0.3, 3.0), random.uniform(0.3, 3.0)}));
            REQUIRE(environment.addObstacle(obstacles.back()).ok());
        }
        environment.setTime(0.0);
        PlaceDef def;
        const auto region = routes(environment).region({-11.5, -11.5});
        const Formation formation = square(36);
        const auto targetsAt = [&](Vec2 centre) {
            std::vector<Vec2> targets;
            for (const MeshPoint& p : formation.places)
                targets.push_back(centre + p.position(formation.mesh.triangles, formation.mesh.vertices));
            return targets;
        };
        PlaceTracker places;
        Vec2 centre{-8, -8};
        places.reset(def, targetsAt(centre), routes(environment), region);
        const Vec2 goal{random.uniform(-6, 8), random.uniform(-6, 8)};
        for (int k = 0; k < 1400; ++k) {
            centre += clampLength(goal - centre, 1.5 * kStep);
            const std::vector<Vec2> before = places.positions();
            places.advance(def, targetsAt(centre), routes(environment), region, kStep);
            for (std::size_t i = 0; i < before.size(); ++i) {
                const Vec2 now = places.positions()[i];
                REQUIRE(isFinite(now));
                REQUIRE(distance(before[i], now) <= def.maxSpeed * kStep + 1e-9);
                for (const ObstacleDef& o : obstacles)
                    REQUIRE(segmentDistance(o.polygon, before[i], now) > def.radius - 3e-3);
            }
        }
        // Updated reachable targets are hardly farther from their targets than those found from scratch; a
        // place does not give up its point for a small gain.
        PlaceTracker fresh;
        fresh.reset(def, targetsAt(centre), routes(environment), region);
        CHECK(closestPair(fresh) >= 2 * def.radius * (1 - 1e-8));
        CHECK(closestPair(places) >= 2 * def.radius * (1 - 1e-8));
        const std::vector<Vec2> targets = targetsAt(centre);
        double updated = 0.0, fromScratch = 0.0;
        for (std::size_t i = 0; i < 36; ++i) {
            ++all;
            arrived += distance(places.reachableTargets()[i], places.positions()[i]) < 1e-6 ? 1 : 0;
            CHECK(places.fit()[i] == 1);
            updated += distance(places.reachableTargets()[i], targets[i]) / 36.0;
            fromScratch += distance(fresh.reachableTargets()[i], targets[i]) / 36.0;
        }
        CHECK(updated <= fromScratch + 0.5 * 2 * def.radius);
    }
    MESSAGE("places on their reachable targets at the end: " << arrived << " of " << all);
    CHECK(arrived == all);
}

TEST_CASE("a moving obstacle pushes places out of itself, never through it") {
    Environment environment = emptyWorld();
    ObstacleDef car = box({-9, -1}, {-7, 1});
    car.path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {16, 0}, 0.0}};
    REQUIRE(environment.addObstacle(car).ok());
    environment.setTime(0.0);
    const std::vector<Vec2> targets{{0, 0}, {0, 0.7}, {0, -0.7}};
    PlaceTracker places;
    places.reset({}, targets, routes(environment), -1);
    double deepest = 1.0;
    for (int k = 1; k < 1200; ++k) {
        environment.setTime(k * kStep);
        const std::vector<Vec2> before = places.positions();
        places.advance({}, targets, routes(environment), -1, kStep);
        for (std::size_t i = 0; i < 3; ++i) {
            REQUIRE(distance(before[i], places.positions()[i]) <= 2.0 * kStep + 1e-9);
            deepest = std::min(deepest, environment.distanceToObstacle(places.positions()[i]));
        }
    }
    MESSAGE("least distance to the car's surface " << deepest << " m");
    for (std::size_t i = 0; i < 3; ++i) CHECK(distance(places.positions()[i], targets[i]) < 1e-9);
}

TEST_CASE("places that are saved on a detour and restored continue with the same bits") {
    Environment environment = emptyWorld();
    REQUIRE(environment.addObstacle(box({-0.5, -6}, {0.5, 6})).ok());
    environment.setTime(0.0);
    std::vector<Vec2> targets;
    for (int k = 0; k < 20; ++k) targets.push_back({-3.0 - k % 4, k / 4 - 2.0});
    PlaceTracker places;
    places.reset({}, targets, routes(environment), -1);
    for (Vec2& t : targets) t.x += 7.0;
    for (int k = 0; k < 90; ++k) places.advance({}, targets, routes(environment), -1, kStep);
    Writer writer;
    writer(places);
    PlaceTracker copy;
    Reader reader(writer.bytes());
    reader(copy);
    REQUIRE(reader.ok());
    for (int k = 0; k < 300; ++k) {
        places.advance({}, targets, routes(environment), -1, kStep);
        copy.advance({}, targets, routes(environment), -1, kStep);
    }
    CHECK(hashOf(copy) == hashOf(places));
}

TEST_CASE("time of a step with ten thousand places") {
    Environment environment = emptyWorld(80.0);
    for (int k = 0; k < 30; ++k) {
        const Vec2 corner{k % 6 * 25.0 - 70.0, k / 6 * 30.0 - 70.0};
        REQUIRE(environment.addObstacle(box(corner, corner + Vec2{4, 4})).ok());
    }
    environment.setTime(0.0);
    std::vector<Vec2> targets;
    for (int k = 0; k < 10000; ++k) targets.push_back({k % 100 - 50.0, k / 100 - 50.0});
    PlaceTracker places;
    places.reset({}, targets, routes(environment), -1);
    double total = 0.0;
    for (int k = 0; k < 60; ++k) {
        for (Vec2& t : targets) t.x += 0.02;
        const auto start = std::chrono::steady_clock::now();
        places.advance({}, targets, routes(environment), -1, kStep);
        total += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
    MESSAGE("advance with 10,000 places: " << total / 60 << " ms");
}
