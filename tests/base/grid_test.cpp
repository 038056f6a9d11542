#include "base/grid.h"

#include <doctest.h>

using namespace muster;

TEST_CASE("a grid covers its box with just enough cells") {
    const Grid grid = Grid::covering({{-16, -16}, {16, 16}}, 0.25);
    CHECK(grid.width == 128);
    CHECK(grid.height == 128);
    CHECK(grid.centre({0, 0}) == Vec2{-15.875, -15.875});
    CHECK(Grid::covering({{0, 0}, {1.01, 1}}, 0.25).width == 5);
}

TEST_CASE("far points and a grid of one cell") {
    const Grid grid = Grid::covering({{0, 0}, {0.1, 0.1}}, 0.5);
    CHECK(grid.count() == 1);
    CHECK(grid.nearestCell({1e300, -1e300}) == Cell{0, 0});
    CHECK_FALSE(grid.contains(grid.cellOf({1e300, 0})));
}
