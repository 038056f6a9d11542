#include "engine/ground/routes/route_graph.h"

#include "engine/ground/routes/route_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

// A wall across a world of 24 m with a door of `width` m at `at` m along it, turned by `angle`.
Environment doorScene(double width, double at, double angle, double thickness, double cell = 0.25) {
    Environment environment = emptyWorld(24.0, cell);
    const Rotation turn{cosine(angle), sine(angle)};
    const auto wall = [&](double from, double to) {
        Polygon corners{
            {from, -0.5 * thickness}, {to, -0.5 * thickness}, {to, 0.5 * thickness}, {from, 0.5 * thickness}};
        for (Vec2& p : corners) p = turn.apply(p);
        REQUIRE(environment.addObstacle(block(corners)).ok());
    };
    wall(-40.0, at - 0.5 * width);
    wall(at + 0.5 * width, 40.0);
    environment.setTime(0.0);
    return environment;
}

}  // namespace

TEST_CASE("points of one region are joined by flood fill of fine cells, and of two regions are not") {
    int pairs = 0, apart = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Random random(seed);
        const double cell = random.below(2) == 0 ? 0.25 : 0.5;
        const Environment environment = obstacleScene(random, 30.0, cell, 75, 2.5);
        RouteGraph graph;
        graph.update(environment, kRadius);
        const FineRegions narrow(environment, kRadius + 0.04, 0.05), wide(environment, kRadius - 0.03, 0.05);
        std::vector<Vec2> points;
        while (points.size() < 60) {
            const Vec2 p{random.uniform(-15, 15), random.uniform(-15, 15)};
            if (narrow.at(p) >= 0) points.push_back(p);
        }
        for (const Vec2 a : points)
            for (const Vec2 b : points) {
                const bool joined = graph.reachable(a, b);
                // Whoever is a little slimmer gets there; whoever is a little wider does not, else.
                if (joined) CHECK(wide.at(a) == wide.at(b));
                if (!joined) CHECK(narrow.at(a) != narrow.at(b));
                ++pairs;
                apart += joined ? 0 : 1;
            }
    }
    CHECK(apart > pairs / 50);
    CHECK(apart < pairs);
}

TEST_CASE(
    "a door is passable exactly where it is as wide as a disc, wherever it lies and however it is turned") {
    Random random(4);
    for (int k = 0; k < 300; ++k) {
        const double at = random.uniform(-3.0, 3.0), angle = random.uniform(0.0, kPi);
        const double thickness = random.uniform(0.02, 1.5);
        const double cell = k % 3 == 0 ? 0.5 : 0.25;
        const Rotation turn{cosine(angle), sine(angle)};
        const Vec2 a = turn.apply({at, 3.0}), b = turn.apply({at, -3.0});
        for (const double width : {0.40, 0.48, 0.55, 0.7, 1.2}) {
            const Environment environment = doorScene(width, at, angle, thickness, cell);
            RouteGraph graph;
            graph.update(environment, kRadius);
            CAPTURE(at);
            CAPTURE(angle);
            CAPTURE(thickness);
            CAPTURE(width);
            CAPTURE(cell);
            // In cells as wide as the disc a door that leaves it 5 cm may be missed, but none is invented.
            if (cell == 0.5 && width == 0.55) continue;
            CHECK(graph.reachable(a, b) == (width >= 0.5));
            CHECK(findRoute(graph, a, b).empty() == (width < 0.5));
        }
    }
}

TEST_CASE("after edits the graph is as one made from scratch") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        Environment environment = obstacleScene(random, 70.0, 0.25, 60, 3.0);
        RouteGraph followed;
        followed.update(environment, kRadius);
        for (int edit = 0; edit < 12; ++edit) {
            const std::span<const ObstacleId> ids = environment.obstacleIds();
            const ObstacleId id = ids[random.below(static_cast<std::uint32_t>(ids.size()))];
            const ObstacleDef def = randomObstacle(random, 30.0, random.below(4) == 0);
            switch (random.below(3)) {
                case 0:
                    (void)environment.addObstacle(def);
                    break;
                case 1:
                    (void)environment.changeObstacle(id, def);
                    break;
                default:
                    (void)environment.removeObstacle(id);
            }
            environment.setTime(0.1 * edit);
            if (edit % 3 == 1) continue;
            followed.update(environment, kRadius);
            RouteGraph fresh;
            fresh.update(environment, kRadius);
            REQUIRE(followed.regionCount() == fresh.regionCount());
            for (int k = 0; k < 40; ++k) {
                const Vec2 a{random.uniform(-35, 35), random.uniform(-35, 35)};
                const Vec2 b{random.uniform(-35, 35), random.uniform(-35, 35)};
                CHECK(followed.region(a) == fresh.region(a));
                CHECK(followed.nearestReachable(a, followed.region(b)) ==
                      fresh.nearestReachable(a, fresh.region(b)));
                CHECK(findRoute(followed, a, b) == findRoute(fresh, a, b));
            }
        }
    }
}

TEST_CASE("the nearest reachable ground is that found among all cells") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Random random(seed);
        const Environment environment = obstacleScene(random, 40.0, 0.25, 130, 2.5);
        RouteGraph graph;
        graph.update(environment, kRadius);
        REQUIRE(graph.regionCount() > 1);
        const Grid& grid = environment.grid();
        for (int k = 0; k < 60; ++k) {
            const Vec2 p{random.uniform(-22, 22), random.uniform(-22, 22)};
            const auto region = static_cast<std::int32_t>(random.below(graph.regionCount() + 1)) - 1;
            const Vec2 found = graph.nearestReachable(p, region);
            const std::int32_t here = graph.region(p);
            if (here >= 0 && (region < 0 || here == region)) {
                CHECK(found == p);
                continue;
            }
            double least = 1e300;
            for (std::int32_t i = 0; i < grid.count(); ++i) {
                const Cell c = grid.at(i);
                const std::int32_t tile = graph.tiles().tileOf(c);
                const std::int32_t component = graph.components(tile).at(TileGrid::localOf(c));
                if (component < 0 || (region >= 0 && graph.regionOf(tile, component) != region)) continue;
                least = std::min(least, distance(p, grid.centre(c)));
            }
            CHECK(distance(p, found) < least + 0.25);
            CHECK(graph.ground().lineClear(found, found));
        }
    }
}

TEST_CASE("regions are counted for a radius, and a single one has the number 0 on all free ground") {
    Environment environment = emptyWorld(16.0, 0.25);
    RouteGraph graph;
    const auto update = [&](double radius) {
        environment.setTime(0.0);
        graph.update(environment, radius);
    };
    REQUIRE(environment.addObstacle(rectangle({-2, -2}, {2, 2})).ok());
    update(0.25);
    CHECK(graph.regionCount() == 1);
    CHECK(graph.region({0, 0}) == -1);
    CHECK(graph.region({-6, 5}) == 0);
    CHECK(graph.region({30, 0}) == -1);
    // A wall with a door for the slim: two rooms for the stout.
    REQUIRE(environment.addObstacle(rectangle({-0.2, 2}, {0.2, 5})).ok());
    REQUIRE(environment.addObstacle(rectangle({-0.2, 6.2}, {0.2, 8})).ok());
    REQUIRE(environment.addObstacle(rectangle({-0.2, -8}, {0.2, -2})).ok());
    update(0.25);
    CHECK(graph.regionCount() == 1);
    CHECK(graph.reachable({-6, 0}, {6, 0}));
    update(0.9);
    CHECK(graph.regionCount() == 2);
    CHECK_FALSE(graph.reachable({-6, 0}, {6, 0}));
    // Nowhere to stand at all.
    update(20.0);
    CHECK(graph.regionCount() == 0);
    CHECK(graph.region({-6, 0}) == -1);
}
