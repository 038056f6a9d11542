#include "base/grid.h"

#include <doctest.h>

#include <atomic>
#include <limits>
#include <vector>

#include "base/bilinear.h"
#include "base/parallel.h"
#include "base/random.h"

using namespace muster;

TEST_CASE("a grid covers its box with just enough cells") {
    const Grid grid = Grid::covering({{-16, -16}, {16, 16}}, 0.25);
    CHECK(grid.width == 128);
    CHECK(grid.height == 128);
    CHECK(grid.centre({0, 0}) == Vec2{-15.875, -15.875});
    CHECK(Grid::covering({{0, 0}, {1.01, 1}}, 0.25).width == 5);
}

TEST_CASE("bilinear interpolation reproduces linear functions and stays inside") {
    const Grid grid = Grid::covering({{0, 0}, {4, 3}}, 0.5);
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 p{random.uniform(0.25, 3.75), random.uniform(0.25, 2.75)};
        const BilinearStencil stencil = bilinearStencil(grid, p);
        double value = 0.0;
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) {
            const Vec2 c = grid.centre(grid.at(stencil.cell[k]));
            value += stencil.weight[k] * (2.0 * c.x - 3.0 * c.y + 1.0);
            sum += stencil.weight[k];
        }
        CHECK(value == doctest::Approx(2.0 * p.x - 3.0 * p.y + 1.0));
        CHECK(sum == doctest::Approx(1.0));
    }
    const BilinearStencil outside = bilinearStencil(grid, {-100, 100});
    for (int k = 0; k < 4; ++k) CHECK(grid.contains(grid.at(outside.cell[k])));
}

TEST_CASE("far points and a single cell are no trouble") {
    const Grid grid = Grid::covering({{0, 0}, {0.1, 0.1}}, 0.5);
    CHECK(grid.count() == 1);
    CHECK(grid.nearestCell({1e300, -1e300}) == Cell{0, 0});
    CHECK(bilinearStencil(grid, {7, 7}).cell[0] == 0);
    CHECK_FALSE(grid.contains(grid.cellOf({1e300, 0})));
}

TEST_CASE("a pool runs every item once, with any number of threads") {
    for (const int threads : {1, 2, 4, 8}) {
        ThreadPool pool(threads);
        for (int round = 0; round < 50; ++round) {
            std::vector<std::atomic<int>> hits(97);
            pool.run(97, [&](std::int32_t item, std::int32_t worker) {
                CHECK(worker < threads);
                ++hits[item];
            });
            for (const auto& hit : hits) REQUIRE(hit.load() == 1);
        }
    }
}
