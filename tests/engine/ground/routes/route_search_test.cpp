#include "engine/ground/routes/route_search.h"

#include <array>

#include "engine/ground/routes/route_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

bool pathIsClear(const Environment& environment, const std::vector<Vec2>& path, double radius) {
    for (std::size_t k = 1; k < path.size(); ++k)
        if (!environment.clearStaticLine(path[k - 1], path[k], radius - 1e-3)) return false;
    return true;
}

}  // namespace

TEST_CASE("routes are as short as those of a visibility graph, within a tenth") {
    double sum = 0.0, worst = 0.0;
    int count = 0, apart = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Random random(seed);
        Environment environment = obstacleScene(random, 60.0, 0.25, 40, 3.0);
        RouteGraph graph;
        graph.update(environment, kRadius);
        const VisibilityGraph reference(environment, kRadius);
        for (int k = 0; k < 30; ++k) {
            const Vec2 a{random.uniform(-29, 29), random.uniform(-29, 29)};
            const Vec2 b{random.uniform(-29, 29), random.uniform(-29, 29)};
            if (!environment.clearStaticLine(a, a, kRadius) || !environment.clearStaticLine(b, b, kRadius))
                continue;
            const double shortest = reference.shortest(a, b);
            const std::vector<Vec2> path = findRoute(graph, a, b);
            CHECK(path.empty() == !graph.reachable(a, b));
            if (path.empty()) {
                ++apart;
                if (shortest < 1e9) MESSAGE("apart, but ", shortest, " m in scene ", seed);
                continue;
            }
            CHECK(path.front() == a);
            CHECK(path.back() == b);
            CHECK(pathIsClear(environment, path, kRadius));
            if (!(shortest < 1e9)) {
                MESSAGE("reached, reference not, scene ", seed);
                continue;
            }
            const double ratio = pathLength(path) / shortest;
            if (ratio > 1.05) MESSAGE("ratio ", ratio, " of ", shortest, " m, scene ", seed);
            sum += ratio;
            worst = std::max(worst, ratio);
            ++count;
        }
    }
    MESSAGE("ratio mean ", sum / count, ", worst ", worst, ", ", count, " routes, ", apart, " apart");
    CHECK(sum / count < 1.05);
    CHECK(worst < 1.1);
}

TEST_CASE("a closed line is not crossed, and the way round it is short") {
    // A wall with three doors.
    Environment environment = emptyWorld(60.0, 0.25);
    for (const auto& [from, to] : {std::pair{-30.0, -20.0}, {-18.0, -1.0}, {1.0, 13.0}, {15.0, 30.0}})
        REQUIRE(environment.addObstacle(rectangle({from, -0.3}, {to, 0.3})).ok());
    environment.setTime(0.0);
    RouteGraph graph;
    graph.update(environment, kRadius);
    const Vec2 a{2, -10}, b{-2, 10};
    const double direct = pathLength(findRoute(graph, a, b));
    const ClosedLine middle{{-1.5, 0}, {1.5, 0}}, right{{12, 0}, {16, 0}}, left{{-21, 0.2}, {-17, -0.2}};
    const auto through = [](double x, double y) {
        return distance({2, -10}, {x - 0.25, y}) + distance({x - 0.25, y}, {-2, 10});
    };
    const auto path = findRoute(graph, a, b, std::array{middle});
    CHECK(direct == doctest::Approx(distance(a, b)).epsilon(0.01));
    CHECK(pathLength(path) == doctest::Approx(through(13.5, 0.0)).epsilon(0.05));
    const RouteGround ground(environment, kRadius, std::array{middle});
    for (std::size_t k = 1; k < path.size(); ++k) CHECK(ground.lineClear(path[k - 1], path[k]));
    CHECK(pathLength(findRoute(graph, a, b, std::array{middle, right})) ==
          doctest::Approx(distance(a, {-18.3, 0}) + distance({-18.3, 0}, b)).epsilon(0.05));
    CHECK(findRoute(graph, a, b, std::array{middle, right, left}).empty());
    CHECK(pathLength(findRoute(graph, a, b)) == direct);
    // A line in the open is walked round.
    const auto round = findRoute(graph, {-25, -20}, {25, -20}, std::array{ClosedLine{{0, -29}, {0, -15}}});
    CHECK(pathLength(round) == doctest::Approx(2 * std::hypot(25, 5)).epsilon(0.02));
}

TEST_CASE("a search cut into pieces finds the same route") {
    Random random(9);
    Environment environment = obstacleScene(random, 100.0, 0.25, 120, 3.0);
    RouteGraph graph;
    graph.update(environment, kRadius);
    RouteSearch search;
    for (int k = 0; k < 20; ++k) {
        const Vec2 a{random.uniform(-50, 50), random.uniform(-50, 50)};
        const Vec2 b{random.uniform(-50, 50), random.uniform(-50, 50)};
        search.start(graph, a, b);
        int pieces = 0;
        while (search.status() == RouteStatus::Searching) {
            std::int64_t budget = 50;
            search.advance(graph, budget);
            ++pieces;
        }
        RouteGraph fresh;
        fresh.update(environment, kRadius);
        CHECK(search.path() == findRoute(fresh, a, b));
        CHECK((search.status() == RouteStatus::Found) == !search.path().empty());
    }
}

TEST_CASE("obstacles that move count only where asked for") {
    Environment environment = emptyWorld(40.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-20, -0.3}, {-2, 0.3})).ok());
    REQUIRE(environment.addObstacle(rectangle({2, -0.3}, {18, 0.3})).ok());
    ObstacleDef gate = rectangle({-3, -0.4}, {3, 0.4});
    gate.path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {30, 0}, 0.0}};
    REQUIRE(environment.addObstacle(gate).ok());
    environment.setTime(0.0);
    RouteGraph graph;
    graph.update(environment, kRadius);
    const Vec2 a{0, -5}, b{0, 5};
    CHECK(graph.reachable(a, b));
    CHECK(pathLength(findRoute(graph, a, b)) == doctest::Approx(10.0));
    const auto round = findRoute(graph, a, b, {}, true);
    CHECK(pathLength(round) == doctest::Approx(2 * std::hypot(18.3, 5)).epsilon(0.05));
    for (std::size_t k = 1; k < round.size(); ++k)
        CHECK(environment.clearLine(round[k - 1], round[k], kRadius - 1e-3));
    environment.setTime(9.0);
    graph.update(environment, kRadius);
    CHECK(pathLength(findRoute(graph, a, b, {}, true)) == doctest::Approx(10.0));
}

TEST_CASE("blocked ends lead to the nearest free ground") {
    Environment environment = emptyWorld(40.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-2, -2}, {2, 2})).ok());
    environment.setTime(0.0);
    RouteGraph graph;
    graph.update(environment, kRadius);
    const auto in = findRoute(graph, {-10, 1}, {1.5, 0});
    REQUIRE(in.size() >= 2);
    CHECK(in.front() == Vec2{-10, 1});
    CHECK(distance(in.back(), {1.5, 0}) < 1.3);
    const auto out = findRoute(graph, {1.5, 0}, {10, 1});
    REQUIRE(out.size() >= 2);
    CHECK(out.front() == Vec2{1.5, 0});
    CHECK(distance(out[1], {1.5, 0}) < 1.3);
    CHECK(out.back() == Vec2{10, 1});
    CHECK(findRoute(graph, {NAN, 0}, {5, 5}).empty());
}
