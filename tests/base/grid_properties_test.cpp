// Invariants of grids of any size and position.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/archive.h"
#include "base/grid.h"
#include "base/random_grids.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("a grid covers its box, and one row or column fewer would not") {
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        const Vec2 corner{random.uniform(-500, 500), random.uniform(-500, 500)};
        const Vec2 size{random.uniform(0.01, 60), random.uniform(0.01, 60)};
        const double cell = random.uniform(0.05, 4.0);
        const Grid grid = Grid::covering({corner, corner + size}, cell);
        CHECK(grid.width * cell >= size.x - 1e-6);
        CHECK(grid.height * cell >= size.y - 1e-6);
        CHECK((grid.width - 1) * cell < size.x);
        CHECK((grid.height - 1) * cell < size.y);
    }
}

TEST_CASE("index and cell are inverse, and the centre of a cell lies in it") {
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        const Grid grid = coveringGrid(random);
        const auto index = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(grid.count())));
        const Cell cell = grid.at(index);
        CHECK(grid.contains(cell));
        CHECK(grid.index(cell) == index);
        CHECK(grid.cellOf(grid.centre(cell)) == cell);
        CHECK(grid.nearestCell(grid.centre(cell)) == cell);
        CHECK(grid.box().contains(grid.centre(cell)));
    }
}

TEST_CASE("the cell of a point is the one with the nearest centre") {
    Random random(13);
    for (int i = 0; i < 60; ++i) {
        const Grid grid = Grid::covering({{-3, 2}, {4, 7}}, random.uniform(0.3, 1.1));
        const Vec2 p{random.uniform(-8, 9), random.uniform(-3, 12)};
        double nearest = INFINITY;
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            const Vec2 away = grid.centre(grid.at(k)) - p;
            nearest = std::min(nearest, std::max(std::fabs(away.x), 0.0) + std::fabs(away.y));
        }
        const Vec2 away = grid.centre(grid.nearestCell(p)) - p;
        CHECK(std::fabs(away.x) + std::fabs(away.y) == doctest::Approx(nearest));
        CHECK((grid.cellOf(p) == grid.nearestCell(p)) == grid.contains(grid.cellOf(p)));
    }
}

TEST_CASE("the nearest cell is that of the point moved into the grid, on edges too") {
    Random random(21);
    for (int i = 0; i < 500; ++i) {
        const Grid grid = coveringGrid(random);
        Vec2 p = pointIn(grid.box().grown(3.0), random);
        // Some lie just on the edge of a cell, or far away.
        if (i % 3 == 0)
            p = grid.centre({static_cast<std::int32_t>(random.uniform(-2, 9)), 1}) -
                Vec2{0.5, 0.5} * grid.cell;
        if (i % 7 == 0) p = p * 1e12;
        const Cell of = grid.cellOf(p);
        const Cell inside{std::clamp(of.x, 0, grid.width - 1), std::clamp(of.y, 0, grid.height - 1)};
        CHECK(grid.nearestCell(p) == inside);
    }
}

TEST_CASE("cells on the negative side are not rounded towards zero") {
    const Grid grid = Grid::covering({{0, 0}, {4, 4}}, 1.0);
    CHECK(grid.cellOf({-0.5, -1.5}) == Cell{-1, -2});
    CHECK(grid.cellOf({-1.0, 0.0}) == Cell{-1, 0});
    CHECK_FALSE(grid.contains({-1, 0}));
    CHECK_FALSE(grid.contains({4, 0}));
    CHECK_FALSE(grid.contains({0, 4}));
    CHECK(grid.contains({3, 3}));
}

TEST_CASE("a grid survives an archive") {
    Random random(16);
    Grid grid = coveringGrid(random), back;
    Writer writer;
    writer(grid);
    Reader reader(writer.bytes());
    reader(back);
    CHECK(reader.ok());
    CHECK(back == grid);
}
