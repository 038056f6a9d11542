#include "base/cell_list.h"

#include <doctest.h>

#include <algorithm>

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
