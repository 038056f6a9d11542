// The static ground: clearance, lines of sight, the coarse copy.
#include <doctest.h>

#include <cmath>

#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/fields/eikonal/geodesic_oracle.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("the uniform clearance is a lower bound of the distance to walls and other ground") {
    Environment environment = squareWorld(24.0);
    REQUIRE(environment.addObstacle(rectangle(-4, -3, 3, 2)).ok());
    REQUIRE(environment.addPatch(slowBox(8, -6, 14, 6, 0.5)).ok());
    const StaticGround ground = groundOf(environment);
    const Shape block{{{-4, -3}, {3, -3}, {3, 2}, {-4, 2}}};
    const Shape patch{{{8, -6}, {14, -6}, {14, 6}, {8, 6}}};
    Random random(3);
    double most = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const Vec2 p{random.uniform(-24, 24), random.uniform(-24, 24)};
        const double edgeDistance = std::min({24 - p.x, p.x + 24, 24 - p.y, p.y + 24});
        const double walls = std::min(block.signedDistance(p), edgeDistance) - 0.25;
        // A patch reaches to the far side of the cells it touches.
        const double edge = std::fabs(patch.signedDistance(p)) + 0.36;
        REQUIRE(ground.uniformClearance(p) <= std::min(walls, edge) + 1e-5);
        most = std::max(most, ground.uniformClearance(p));
    }
    CHECK(most > 6.0);
    CHECK(ground.uniformClearance({30, 0}) < 0.0);
}

TEST_CASE("lines of sight agree with exact distances except very near walls") {
    Environment environment = squareWorld(16.0);
    std::vector<Shape> shapes;
    Random random(5);
    for (int k = 0; k < 25; ++k) {
        ObstacleDef tree{.centre = {random.uniform(-13, 13), random.uniform(-13, 13)},
                         .radius = random.uniform(0.3, 1.2)};
        REQUIRE(environment.addObstacle(tree).ok());
        shapes.push_back({{tree.centre}, tree.radius});
    }
    const StaticGround ground = groundOf(environment);
    int clear = 0;
    int blocked = 0;
    for (int k = 0; k < 3000; ++k) {
        const Vec2 a = freeSpot(environment, random, 15.0);
        const Vec2 b = freeSpot(environment, random, 15.0);
        double gap = 1e9;
        for (const Shape& shape : shapes) gap = std::min(gap, shape.segmentDistance(a, b));
        if (gap > 0.25 + 0.06) {
            REQUIRE(ground.lineOfSight(a, b));
            ++clear;
        } else if (gap < 0.25 - 0.08) {
            REQUIRE_FALSE(ground.lineOfSight(a, b));
            ++blocked;
        }
    }
    CHECK(clear > 300);
    CHECK(blocked > 300);
}

TEST_CASE("on slow ground there is a line of sight only where no path outside can be faster") {
    Environment environment = squareWorld(16.0);
    REQUIRE(environment.addPatch(slowBox(-6, -6, 6, 6, 0.2)).ok());
    const StaticGround ground = groundOf(environment);
    CHECK(ground.lineOfSight({-0.5, 0}, {0.5, 0}));
    CHECK_FALSE(ground.lineOfSight({-5, 5.5}, {5, 5.5}));  // The path along the fast side is cheaper.
    CHECK_FALSE(ground.lineOfSight({-8, 0}, {0, 0}));      // Across the edge.
    CHECK(ground.lineOfSight({-9, -9}, {-9, 9}));
    CHECK(ground.unitCost({0, 0}) == doctest::Approx(5.0));
    CHECK(ground.unitCost({10, 0}) == 1.0f);
    CHECK(ground.lineCost({-9, 0}, {9, 0}) > 60.0 * 0.8);
    CHECK(ground.lineCost({-9, 8}, {9, 8}) == doctest::Approx(18.0));
}

TEST_CASE("the coarse copy keeps walls closed and doors open") {
    Environment environment = squareWorld(60.0);
    // A wall 0.1 m thick right across, with one door of 2 m.
    REQUIRE(environment.addObstacle(rectangle(0.37, -60, 0.47, 9.2)).ok());
    REQUIRE(environment.addObstacle(rectangle(0.37, 11.2, 0.47, 60)).ok());
    const StaticGround ground = groundOf(environment);
    CHECK(ground.coarse().grid.count() <= StaticGround::kMaxCoarseCells);
    CHECK(ground.coarse().grid.cell >= 2.0 * environment.grid().cell);
    EikonalSolver solver;
    CostField field;
    solver.solve(ground.coarse(), {20.0, 0.0}, {}, field);
    const double half = std::hypot(20.0 - 0.4, 10.2);
    CHECK(field.cost({-19.2, 0.0}) == doctest::Approx(2.0 * half).epsilon(0.04));

    REQUIRE(environment.addObstacle(rectangle(0.37, 9.0, 0.47, 11.4)).ok());
    StaticGround closed = groundOf(environment);
    solver.solve(closed.coarse(), {20.0, 0.0}, {}, field);
    CHECK_FALSE(std::isfinite(field.cost({-19.2, 0.0})));
}

TEST_CASE("partially blocked coarse cells have values from their free side") {
    Environment environment = squareWorld(60.0);
    // A wall whose lower face lies a little above the border of a row of coarse cells.
    const double edge = groundOf(environment).coarse().grid.cell;
    const double face = -60.0 + edge * 60.0 + 0.35 * edge + 0.25;
    REQUIRE(environment.addObstacle(rectangle(-60, face, 20, face + 3.0 * edge)).ok());
    const StaticGround ground = groundOf(environment);
    const Grid& grid = ground.coarse().grid;
    REQUIRE(grid.cell == edge);
    REQUIRE_FALSE(ground.partiallyBlockedCells().empty());
    for (const StaticGround::PartiallyBlockedCell& blocked : ground.partiallyBlockedCells()) {
        const Vec2 middle = grid.centre(blocked.cell);
        CHECK(environment.distanceToObstacle(middle) < 0.25 + environment.grid().cell);
        CHECK(environment.distanceToObstacle(grid.centre(blocked.neighbour)) >= 0.25);
        CHECK(std::abs(blocked.cell.x - blocked.neighbour.x) +
                  std::abs(blocked.cell.y - blocked.neighbour.y) ==
              1);
        CHECK(blocked.cost == doctest::Approx(edge));
    }
    // Values can be set there, and only be lowered.
    EikonalSolver solver;
    CostField field;
    solver.solve(ground.coarse(), {5.0, face - 8.0}, {}, field);
    const Cell cell = ground.partiallyBlockedCells()[20].cell;
    CHECK(field.value(cell) > 60.0f);  // Round the end of the wall, or infinite.
    field.lowerValue(cell, 40.0f);
    CHECK(field.value(cell) == 40.0f);
    field.lowerValue(cell, 50.0f);
    CHECK(field.value(cell) == 40.0f);
    field.lowerValue({-1, 4000}, 1.0f);  // No such cell.
}

TEST_CASE("the static ground changes only with what stands still") {
    Environment environment = squareWorld(12.0);
    ObstacleDef cart{
        .centre = {0, 0}, .radius = 0.5, .path = {.waypoints = {{0.0, {0, 0}, 0.0}, {4.0, {8, 0}, 0.0}}}};
    REQUIRE(environment.addObstacle(cart).ok());
    StaticGround ground;
    ground.update(environment, 1.0, 0.25);
    const std::uint32_t version = ground.version();
    environment.setTime(1.0);
    ground.update(environment, 1.0, 0.25);
    CHECK(ground.version() == version);
    CHECK(ground.lineOfSight({-4, 0}, {4, 0}));  // Moving obstacles are not part of it.
    REQUIRE(environment.addObstacle(rectangle(-1, -1, 1, 1)).ok());
    ground.update(environment, 1.0, 0.25);
    CHECK(ground.version() == version + 1);
    CHECK_FALSE(ground.lineOfSight({-4, 0}, {4, 0}));
    ground.update(environment, 1.0, 0.5);
    CHECK(ground.version() == version + 2);
}
