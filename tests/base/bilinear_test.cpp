#include "base/bilinear.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random_grids.h"

using namespace muster;
using namespace muster::test;

namespace {

double interpolate(const Grid& grid, const std::vector<double>& values, Vec2 p) {
    const BilinearStencil stencil = bilinearStencil(grid, p);
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += stencil.weight[k] * values[stencil.cell[k]];
    return sum;
}

}  // namespace

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

TEST_CASE("bilinear weights are a share of one, in the cells that surround the point") {
    Random random(14);
    for (int i = 0; i < 500; ++i) {
        const Grid grid = coveringGrid(random);
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

TEST_CASE("a locator gives the stencil of the same point") {
    Random random(17);
    for (int i = 0; i < 500; ++i) {
        const Grid grid = coveringGrid(random);
        const BilinearLocator locator(grid);
        const Vec2 p = pointIn(grid.box().grown(3.0), random);
        const BilinearStencil stencil = bilinearStencil(grid, p);
        const BilinearLocator::Location at = locator.at(p);
        const float weight[] = {(1 - at.fx) * (1 - at.fy), at.fx * (1 - at.fy), (1 - at.fx) * at.fy,
                                at.fx * at.fy};
        const std::int32_t cell[] = {at.low, at.low + locator.right(), at.low + locator.up(),
                                     at.low + locator.up() + locator.right()};
        // Rounding may assign a point on the border of two squares to either.
        double sum = 0.0, expected = 0.0;
        for (int k = 0; k < 4; ++k) {
            REQUIRE(grid.contains(grid.at(cell[k])));
            sum += weight[k] * grid.at(cell[k]).x;
            expected += stencil.weight[k] * grid.at(stencil.cell[k]).x;
        }
        CHECK(sum == doctest::Approx(expected).epsilon(1e-5));
        CHECK(interpolateBilinear(1.0f, 2.0f, 3.0f, 4.0f, at.fx, at.fy) ==
              doctest::Approx(1.0f + at.fx + 2.0f * at.fy));
    }
}
