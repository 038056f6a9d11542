// Grids of any size and place: what must hold of all of them.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/archive.h"
#include "base/bilinear.h"
#include "base/grid.h"
#include "base/random.h"

using namespace muster;

namespace {

Grid randomGrid(Random& random) {
    const Vec2 corner{random.uniform(-500, 500), random.uniform(-500, 500)};
    const Vec2 size{random.uniform(0.01, 60), random.uniform(0.01, 60)};
    return Grid::covering({corner, corner + size}, random.uniform(0.05, 4.0));
}

Vec2 pointIn(const Box& box, Random& random) {
    return {random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y)};
}

double interpolate(const Grid& grid, const std::vector<double>& values, Vec2 p) {
    const BilinearStencil stencil = bilinearStencil(grid, p);
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += stencil.weight[k] * values[stencil.cell[k]];
    return sum;
}

}  // namespace

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
        const Grid grid = randomGrid(random);
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
        const Grid grid = randomGrid(random);
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

TEST_CASE("bilinear weights are a share of one, in the cells that surround the point") {
    Random random(14);
    for (int i = 0; i < 500; ++i) {
        const Grid grid = randomGrid(random);
        const Vec2 p = pointIn(grid.box().grown(3.0), random);
        const BilinearStencil stencil = bilinearStencil(grid, p);
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) {
            CHECK(stencil.weight[k] >= 0.0);
            CHECK(stencil.weight[k] <= 1.0);
            REQUIRE(grid.contains(grid.at(stencil.cell[k])));
            sum += stencil.weight[k];
            if (stencil.weight[k] == 0.0 || !grid.box().contains(p)) continue;
            const Vec2 away = grid.centre(grid.at(stencil.cell[k])) - p;
            CHECK(std::max(std::fabs(away.x), std::fabs(away.y)) <= grid.cell * (1.0 + 1e-9));
        }
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE("interpolation is exact at centres, bounded by its samples and continuous across cells") {
    Random random(15);
    const Grid grid = Grid::covering({{-2, -1}, {3, 4}}, 0.5);
    std::vector<double> values;
    for (std::int32_t i = 0; i < grid.count(); ++i) values.push_back(random.uniform(-5, 5));
    for (std::int32_t i = 0; i < grid.count(); ++i)
        CHECK(interpolate(grid, values, grid.centre(grid.at(i))) == doctest::Approx(values[i]));
    const double low = *std::min_element(values.begin(), values.end());
    const double high = *std::max_element(values.begin(), values.end());
    for (int i = 0; i < 1000; ++i) {
        const Vec2 p = pointIn(grid.box().grown(1.0), random);
        const double value = interpolate(grid, values, p);
        CHECK(value >= low - 1e-12);
        CHECK(value <= high + 1e-12);
        // The steepest slope between neighbours is (high - low) / cell along each axis.
        const Vec2 q = p + Vec2{random.uniform(-1e-6, 1e-6), random.uniform(-1e-6, 1e-6)};
        CHECK(std::fabs(interpolate(grid, values, q) - value) <= 2.0 * (high - low) / grid.cell * 2e-6);
    }
}

TEST_CASE("beyond the outermost centres the edge goes on") {
    const Grid grid = Grid::covering({{0, 0}, {3, 2}}, 1.0);
    const std::vector<double> values{1, 2, 3, 4, 5, 6};
    CHECK(interpolate(grid, values, {-50, -50}) == 1.0);
    CHECK(interpolate(grid, values, {50, -50}) == 3.0);
    CHECK(interpolate(grid, values, {-50, 50}) == 4.0);
    CHECK(interpolate(grid, values, {1e300, 1e300}) == 6.0);
    CHECK(interpolate(grid, values, {0.1, 1.0}) == doctest::Approx(2.5));
}

TEST_CASE("one row, one column: the other axis still interpolates") {
    const Grid row = Grid::covering({{0, 0}, {4, 1}}, 1.0);
    REQUIRE(row.height == 1);
    CHECK(interpolate(row, {0, 10, 20, 30}, {2.0, 0.3}) == doctest::Approx(15.0));
    const Grid column = Grid::covering({{0, 0}, {1, 4}}, 1.0);
    REQUIRE(column.width == 1);
    CHECK(interpolate(column, {0, 10, 20, 30}, {0.9, 3.25}) == doctest::Approx(27.5));
}

TEST_CASE("a grid survives an archive") {
    Random random(16);
    Grid grid = randomGrid(random), back;
    Writer writer;
    writer(grid);
    Reader reader(writer.bytes());
    reader(back);
    CHECK(reader.ok());
    CHECK(back == grid);
}
