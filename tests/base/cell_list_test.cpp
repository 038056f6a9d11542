#include "base/cell_list.h"

#include <doctest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "base/random.h"

using namespace muster;

TEST_CASE("every point is in its cell once, in ascending order; cells are few and wide enough") {
    Random random(8);
    CellList cells;
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> points(1 + random.below(80));
        const double wide = random.uniform(0, 3) < 1 ? 1e4 : 5.0, high = random.uniform(0, 3) < 1 ? 0.0 : 7.0;
        for (Vec2& p : points) p = {random.uniform(-wide, wide), random.uniform(-1e-9, high)};
        cells.sort(points, 0.5);
        const Grid& grid = cells.grid();
        CHECK(grid.cell >= 0.5);
        CHECK(grid.count() <= static_cast<std::int32_t>(16 * points.size() + 64));
        std::size_t seen = 0;
        for (std::int32_t c = 0; c < grid.count(); ++c) {
            const auto here = cells.within(c, c);
            seen += here.size();
            CHECK(std::is_sorted(here.begin(), here.end()));
            for (const std::int32_t k : here) {
                CHECK(cells.cellOf(static_cast<std::size_t>(k)) == c);
                CHECK(grid.index(grid.cellOf(points[k])) == c);
            }
        }
        CHECK(seen == points.size());
        CHECK(cells.within(0, grid.count() - 1).size() == points.size());
    }
    cells.sort({}, 0.5);
    CHECK(cells.grid().count() == 0);
}

TEST_CASE(
    "pairs within reach are visited once each, as brute force finds them, in the same order every time") {
    Random random(18);
    CellList cells;
    for (int round = 0; round < 100; ++round) {
        std::vector<Vec2> points(random.below(120));
        const double wide = round % 3 == 0 ? 0.4 : 6.0;
        for (Vec2& p : points) p = {random.uniform(-wide, wide), random.uniform(-wide, wide)};
        if (points.size() > 3) points[3] = points[1];
        const double edge = random.uniform(0.3, 2.0), reach = edge * random.uniform(0.2, 1.0);
        std::set<std::pair<std::int32_t, std::int32_t>> expected;
        for (std::int32_t i = 0; i < std::ssize(points); ++i) {
            for (std::int32_t j = i + 1; j < std::ssize(points); ++j)
                if (lengthSquared(points[j] - points[i]) < reach * reach) expected.insert({i, j});
        }
        std::vector<std::pair<std::int32_t, std::int32_t>> found, again;
        cells.sort(points, edge);
        cells.forPairs(reach, [&](std::int32_t i, std::int32_t j) { found.push_back({i, j}); });
        cells.sort(points, edge);
        cells.forPairs(reach, [&](std::int32_t i, std::int32_t j) { again.push_back({i, j}); });
        CHECK(found == again);
        CHECK(found.size() == expected.size());
        CHECK(std::set(found.begin(), found.end()) == expected);
    }
}
