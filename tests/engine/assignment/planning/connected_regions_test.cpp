#include "engine/assignment/planning/exact/connected_regions.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/assignment/planning/plan_scene.h"

using muster::ConnectedRegions;
using muster::UnitCost;

TEST_CASE("open ground is one region, and points outside belong to it") {
    ConnectedRegions regions;
    regions.label(muster_test::uniformGround({{-4, -4}, {4, 4}}, 0.5));
    CHECK(regions.at({0, 0}) == 0);
    CHECK(regions.at({-3.9, 3.9}) == 0);
    CHECK(regions.at({100, -100}) == 0);
}

TEST_CASE("a wall splits the ground; a gap joins it; corners do not") {
    UnitCost cost = muster_test::uniformGround({{-4, -4}, {4, 4}}, 0.5);
    muster_test::addWall(cost, {{-0.5, -4}, {0.5, 4}});
    ConnectedRegions regions;
    regions.label(cost);
    CHECK(regions.at({-2, 0}) == 0);
    CHECK(regions.at({2, 0}) == 1);
    // A point in the wall belongs to the nearer side.
    CHECK(regions.at({-0.3, 1}) == 0);
    CHECK(regions.at({0.3, 1}) == 1);

    UnitCost gap = muster_test::uniformGround({{-4, -4}, {4, 4}}, 0.5);
    muster_test::addWall(gap, {{-0.5, -4}, {0.5, 3.4}});
    regions.label(gap);
    CHECK(regions.at({-2, 0}) == regions.at({2, 0}));

    UnitCost corner = muster_test::uniformGround({{0, 0}, {1, 1}}, 0.5);
    muster_test::addWall(corner, {{0, 0}, {0.5, 0.5}});
    muster_test::addWall(corner, {{0.5, 0.5}, {1, 1}});
    regions.label(corner);
    CHECK(regions.at({0.75, 0.25}) != regions.at({0.25, 0.75}));
}

TEST_CASE("the nearest free point is that of a search over all cells") {
    UnitCost cost = muster_test::uniformGround({{0, 0}, {10, 10}}, 0.5);
    muster_test::addWall(cost, {{2, 0}, {8, 10}});
    ConnectedRegions regions;
    regions.label(cost);
    muster::Random random(4);
    for (int k = 0; k < 200; ++k) {
        const muster::Vec2 p{random.uniform(2.1, 7.9), random.uniform(0, 10)};
        if (std::abs(p.x - 5.0) < 0.01) continue;
        CHECK(regions.at(p) == (p.x < 5.0 ? 0 : 1));
        const muster::Vec2 freePoint = regions.nearestFreePoint(p);
        double nearest = muster_test::kUnreachable;
        for (std::int32_t c = 0; c < cost.grid.count(); ++c)
            if (!cost.wall(c)) nearest = std::min(nearest, distance(p, cost.grid.centre(cost.grid.at(c))));
        // At the edge of the wall a free cell is among the four around the point.
        if (p.x > 2.3 && p.x < 7.7)
            CHECK(distance(p, freePoint) == nearest);
        else
            CHECK((freePoint == p || distance(p, freePoint) == nearest));
    }
}

TEST_CASE("without free cells there is no region") {
    UnitCost cost = muster_test::uniformGround({{0, 0}, {2, 2}}, 0.5);
    muster_test::addWall(cost, {{0, 0}, {2, 2}});
    ConnectedRegions regions;
    regions.label(cost);
    CHECK(regions.at({1, 1}) == -1);
}
