#include "engine/ground/routes/shared_ways.h"

#include "engine/ground/routes/route_scene.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("those who go nearly the same way share one, and theirs is nearly as short as their own") {
    int joined = 0, asked = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        const Environment environment = obstacleScene(random, 120.0, 0.25, 90, 4.0);
        RouteGraph graph;
        graph.update(environment, kRadius);
        SharedWays ways;
        ways.age();
        const Vec2 a = graph.nearestReachable({-50, random.uniform(-50, 50)}, 0);
        const Vec2 b = graph.nearestReachable({50, random.uniform(-50, 50)}, 0);
        ways.add(findRoute(graph, a, b));
        for (int k = 0; k < 60; ++k) {
            const Vec2 from = graph.nearestReachable(a + Vec2{random.uniform(-4, 12), random.uniform(-4, 4)},
                                                     0);
            const Vec2 to = graph.nearestReachable(b + Vec2{random.uniform(-4, 4), random.uniform(-4, 4)}, 0);
            std::vector<Vec2> path;
            std::int64_t work = 0;
            ++asked;
            if (!ways.join(graph.ground(), from, to, path, work)) continue;
            ++joined;
            REQUIRE(path.front() == from);
            REQUIRE(path.back() == to);
            for (std::size_t i = 1; i < path.size(); ++i)
                CHECK(graph.ground().lineClear(path[i - 1], path[i]));
            CHECK(pathLength(path) <= 1.1 * pathLength(findRoute(graph, from, to)) + 0.5);
            CHECK(ways.lengthAlong(from, to, 20.0) >= pathLength(path) - 1e-9);
        }
    }
    CHECK(joined > asked / 2);
}

TEST_CASE("a way that an obstacle has blocked serves nobody, nor does an old one") {
    Environment environment = emptyWorld(60.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-1, -20}, {1, 20})).ok());
    environment.setTime(0.0);
    RouteGraph graph;
    graph.update(environment, kRadius);
    SharedWays ways;
    ways.age();
    ways.add(findRoute(graph, {-10, 5}, {10, 5}));
    std::vector<Vec2> path;
    std::int64_t work = 0;
    CHECK(ways.join(graph.ground(), {-10, 6}, {10, 6}, path, work));
    CHECK(work > 0);
    REQUIRE(environment.addObstacle(rectangle({-1, 20}, {1, 30})).ok());
    environment.setTime(0.0);
    graph.update(environment, kRadius);
    ways.age();
    CHECK(!ways.join(graph.ground(), {-10, 6}, {10, 6}, path, work));
    CHECK(path.empty());
    ways.clear();
    ways.add(findRoute(graph, {-10, 5}, {10, 5}));
    for (int k = 0; k < 1000; ++k) ways.age();
    CHECK(ways.lengthAlong({-10, 5}, {10, 5}, 5.0) > 1e9);
}
