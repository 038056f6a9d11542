#include <doctest.h>

#include <cmath>

#include "environment/a_star.h"
#include "environment/scene.h"

using namespace muster;
using namespace muster::test;

namespace {

double lengthOf(const std::vector<Vec2>& path) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += distance(path[i], path[i + 1]);
    return sum;
}

// Cheapest path on the cells by relaxing until nothing changes; infinity where there is none.
double relaxedCost(const Grid& grid, std::span<const float> clearance, double radius, std::int32_t start,
                   std::int32_t goal) {
    std::vector<double> cost(grid.count(), INFINITY);
    const auto free = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) && clearance[grid.index({x, y})] >= radius;
    };
    cost[start] = 0.0;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::int32_t i = 0; i < grid.count(); ++i) {
            const Cell c = grid.at(i);
            for (int k = 0; k < 9; ++k) {
                const std::int32_t dx = k % 3 - 1, dy = k / 3 - 1;
                if (k == 4 || !free(c.x, c.y) || !free(c.x + dx, c.y + dy) || !free(c.x + dx, c.y) ||
                    !free(c.x, c.y + dy))
                    continue;
                const double step = dx != 0 && dy != 0 ? std::sqrt(2.0) : 1.0;
                const double through = cost[grid.index({c.x + dx, c.y + dy})] + step;
                if (through < cost[i] - 1e-9) {
                    cost[i] = through;
                    changed = true;
                }
            }
        }
    }
    return cost[goal];
}

}  // namespace

TEST_CASE("A* paths on the cells are the cheapest") {
    Random random(14);
    AStar search;
    for (int round = 0; round < 12; ++round) {
        Environment environment = emptyWorld(20.0, 0.5);
        for (int i = 0; i < 20; ++i)
            REQUIRE(environment.addObstacle(randomObstacle(random, 9.0, false)).ok());
        const Grid& grid = environment.grid();
        for (int i = 0; i < 6; ++i) {
            const auto start = static_cast<std::int32_t>(
                random.below(static_cast<std::uint32_t>(grid.count())));
            const auto goal = static_cast<std::int32_t>(
                random.below(static_cast<std::uint32_t>(grid.count())));
            if (environment.clearance()[start] < 0.3 || environment.clearance()[goal] < 0.3) continue;
            const double expected = relaxedCost(grid, environment.clearance(), 0.3, start, goal);
            const auto cells = search.run(grid, environment.clearance(), 0.3, start, goal, 1000000);
            CHECK(cells.empty() == std::isinf(expected));
            if (cells.empty()) continue;
            double cost = 0.0;
            for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
                cost += distance(grid.centre(grid.at(cells[k])), grid.centre(grid.at(cells[k + 1]))) /
                        grid.cell;
            }
            CHECK(cost == doctest::Approx(expected));
            CHECK(cells.front() == start);
            CHECK(cells.back() == goal);
        }
    }
}

TEST_CASE("round a block the smoothed path is little longer than the shortest") {
    Environment environment = emptyWorld(20.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-1, -6}, {1, 6})).ok());
    const Vec2 a{-5, 0}, b{5, 0};
    const auto path = environment.findPath(a, b, 0.25);
    REQUIRE(path.size() >= 4);
    CHECK(path.front() == a);
    CHECK(path.back() == b);
    // Exact: two legs to the corners grown by the radius, and 2 m along the top.
    const double leg = std::sqrt(36.0 + 16.0 - 0.0625);
    CHECK(lengthOf(path) > 2 * leg + 2.0);
    CHECK(lengthOf(path) < 1.04 * (2 * leg + 2.0 + 0.5));
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        CHECK(environment.clearLine(path[i], path[i + 1], 0.25));
    // Straight where one can see.
    CHECK(environment.findPath({-5, 0}, {-5, 8}, 0.25).size() == 2);
    // A moving door counts where it stands.
    ObstacleDef door = rectangle({-1, 6}, {1, 10});
    door.path.waypoints = {{0.0, {0, 0}, 0.0}, {1.0, {8, 0}, 0.0}};
    ObstacleDef low = rectangle({-1, -10}, {1, -6});
    REQUIRE(environment.addObstacle(low).ok());
    REQUIRE(environment.addObstacle(door).ok());
    CHECK(environment.findPath(a, b, 0.25).empty());
    environment.setTime(1.0);
    CHECK(!environment.findPath(a, b, 0.25).empty());
    CHECK(environment.findPath(a, b, 0.25, 10).empty());
}

TEST_CASE("blocked ends use the nearest free cell") {
    Environment environment = emptyWorld(20.0, 0.25);
    REQUIRE(environment.addObstacle(rectangle({-2, -2}, {2, 2})).ok());
    const auto out = environment.findPath({1.5, 0}, {5, 5}, 0.3);
    REQUIRE(out.size() >= 2);
    CHECK(out.front() == Vec2{1.5, 0});
    CHECK(out.back() == Vec2{5, 5});
    const auto in = environment.findPath({5, 0}, {1.5, 0}, 0.3);
    REQUIRE(in.size() >= 2);
    CHECK(environment.distanceToObstacle(in.back()) >= 0.3 - 1e-6);
    CHECK(in.back().x < 3.0);
    CHECK(environment.findPath({NAN, 0}, {5, 5}, 0.3).empty());
    Environment full = emptyWorld(4.0, 0.5);
    REQUIRE(full.addObstacle(rectangle({-5, -5}, {5, 5})).ok());
    CHECK(full.findPath({0, 0}, {1, 1}, 0.3).empty());
}
