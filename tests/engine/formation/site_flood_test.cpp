// Floods find room wherever a region has some, the nearest first.
#include "engine/formation/places/site_flood.h"

#include <doctest.h>

#include "engine/formation/places/place_tracker.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

// A corridor of 60 m along x, `width` wide, in a square world.
Environment corridor(double width) {
    Environment environment = emptyWorld(62.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-31, -31}, {31, -0.5 * width})).ok());
    REQUIRE(environment.addObstacle(rectangle({-31, 0.5 * width}, {31, 31})).ok());
    environment.setTime(0.0);
    return environment;
}

double leastDistance(const std::vector<Vec2>& points) {
    double least = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(points[i], points[j]));
    return least;
}

}  // namespace

TEST_CASE("a flood offers each point once, and serves all who want one from near to far") {
    const Environment environment = corridor(3.0);
    RouteGraph routes;
    routes.update(environment, 0.25);
    SiteFlood flood;
    flood.begin(routes, routes.region({0, 0}), 0.6);
    CHECK(flood.empty());
    for (std::int32_t k = 0; k < 100; ++k) flood.add(k, {0, 0});
    std::vector<Vec2> taken(100, Vec2{1e9, 1e9});
    std::vector<Vec2> offered;
    const bool served = flood.run(1, [&](std::int32_t place, Vec2 p) {
        offered.push_back(p);
        if (!environment.clearStaticLine(p, p, 0.25)) return false;
        for (const Vec2 other : taken)
            if (distance(other, p) < 0.6 - 1e-9) return false;
        taken[place] = p;
        return true;
    });
    CHECK(served);
    CHECK(leastDistance(offered) > 0.0);
    double farthest = 0.0;
    for (const Vec2 p : taken) farthest = std::max(farthest, std::fabs(p.x));
    // A hundred points with 0.31 to 0.45 square metres each fill 2.5 m of the width on either side.
    CHECK(farthest < 100 * 0.45 / 2.5 / 2.0 + 1.0);
    CHECK(farthest > 100 * 0.31 / 2.5 / 2.0 - 1.0);
}

TEST_CASE("a region that is full is found out") {
    const Environment environment = corridor(3.0);
    RouteGraph routes;
    routes.update(environment, 0.25);
    SiteFlood flood;
    flood.begin(routes, -1, 0.6);
    flood.add(0, {5, 0});
    int count = 0;
    CHECK_FALSE(flood.run(1, [&](std::int32_t, Vec2) {
        ++count;
        return false;
    }));
    // All the lattice points of 60 m by 2.5 m at least.
    CHECK(count > 60 * 2.5 / (0.6 * 0.6));
}

TEST_CASE("a formation in rock gets as many places as its corridor has room for, all apart") {
    const Environment environment = corridor(1.5);
    RouteGraph routes;
    routes.update(environment, 0.25);
    // 12 m square, nearly all of it in rock: eight rings of points reach 4 m only.
    std::vector<Vec2> targets;
    for (int k = 0; k < 144; ++k) targets.push_back({k % 12 - 5.5, k / 12 - 5.5});
    PlaceTracker places;
    const PlaceDef def;
    places.reset(def, targets, routes, routes.region({0, 0}));
    CHECK(std::count(places.fit().begin(), places.fit().end(), 1) == 144);
    CHECK(leastDistance(places.reachableTargets()) >= 0.5 * (1.0 - 1e-9));
    for (const Vec2 p : places.reachableTargets()) CHECK(environment.distanceToObstacle(p) >= 0.25);
    // Led on, they keep their points.
    for (int step = 0; step < 400; ++step) {
        for (Vec2& p : targets) p.x += 0.02;
        places.advance(def, targets, routes, routes.region({0, 0}), 1.0 / 60.0);
    }
    CHECK(std::count(places.fit().begin(), places.fit().end(), 1) == 144);
    CHECK(leastDistance(places.reachableTargets()) >= 0.5 * (1.0 - 1e-9));
}

TEST_CASE("the order of a flood runs along the ground from one end to the other") {
    const Environment environment = corridor(1.5);
    RouteGraph routes;
    routes.update(environment, 0.25);
    SiteFlood flood;
    flood.begin(routes, routes.region({0, 0}), 1.0);
    std::vector<double> x;
    for (std::int32_t k = 0; k < 40; ++k) {
        x.push_back(k * 17 % 40 - 19.5);
        flood.add(k, {x.back(), k % 2 == 0 ? 0.49 : -0.49});
    }
    std::vector<std::int32_t> order;
    REQUIRE(flood.order(100000, order));
    REQUIRE(order.size() == 40);
    const double sign = x[order[0]] < 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 1; k < order.size(); ++k) CHECK(sign * (x[order[k]] - x[order[k - 1]]) > 0.0);
    CHECK_FALSE(flood.order(50, order));
}

TEST_CASE("places in walls leave room to pass, unless the region is too full for that") {
    const Environment environment = corridor(4.0);
    RouteGraph routes;
    routes.update(environment, 0.25);
    const PlaceDef def;
    // Of 60 m by 3.5 m the first takes most at 0.75 m, the second more than all.
    for (const std::int32_t count : {240, 500}) {
        CAPTURE(count);
        std::vector<Vec2> targets;
        for (std::int32_t k = 0; k < count; ++k) targets.push_back({k % 12 - 5.5, k / 12 - count / 24.0});
        PlaceTracker places;
        places.reset(def, targets, routes, routes.region({0, 0}));
        CHECK(std::count(places.fit().begin(), places.fit().end(), 1) == count);
        CHECK(leastDistance(places.reachableTargets()) >= (count == 240 ? 0.75 : 0.5) * (1.0 - 1e-9));
    }
}

TEST_CASE("led on along a corridor, places in walls keep their order and go hardly farther than they must") {
    const Environment environment = corridor(3.0);
    RouteGraph routes;
    routes.update(environment, 0.25);
    const PlaceDef def;
    std::vector<Vec2> targets;
    for (std::int32_t k = 0; k < 160; ++k) targets.push_back({k % 12 - 14.5, k / 12 - 6.5});
    PlaceTracker places;
    places.reset(def, targets, routes, routes.region({0, 0}));
    std::vector<Vec2> before = places.reachableTargets();
    for (Vec2& p : targets) p.x += 8.0;
    places.advance(def, targets, routes, routes.region({0, 0}), 1.0 / 60.0);
    std::vector<Vec2> after = places.reachableTargets();
    double sum = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) sum += distance(before[k], after[k]);
    // Along a line nothing is shorter than to keep the order.
    const auto alongX = [](Vec2 a, Vec2 b) { return a.x < b.x; };
    std::sort(before.begin(), before.end(), alongX);
    std::sort(after.begin(), after.end(), alongX);
    double least = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) least += std::fabs(after[k].x - before[k].x);
    CHECK(sum >= least);
    CHECK(sum < 1.25 * least);
    MESSAGE("way of all points " << sum << " m, least " << least << " m");
}
