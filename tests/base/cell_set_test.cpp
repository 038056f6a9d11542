#include "base/cell_set.h"

#include <doctest.h>

#include "base/random.h"
#include "base/summed_area_table.h"

using namespace muster;

TEST_CASE("a cell set holds each cell once, in order of insertion, and is cleared") {
    CellSet cells;
    cells.reset(10);
    CHECK(cells.empty());
    CHECK(cells.insert(7));
    CHECK(cells.insert(2));
    CHECK_FALSE(cells.insert(7));
    CHECK(cells.contains(2));
    CHECK_FALSE(cells.contains(3));
    REQUIRE(cells.members().size() == 2);
    CHECK(cells.members()[0] == 7);
    CHECK(cells.members()[1] == 2);
    CHECK(cells.flags()[7] == 1);
    cells.clear();
    CHECK(cells.empty());
    CHECK_FALSE(cells.contains(7));
    CHECK(cells.capacity() == 10);
}

TEST_CASE("a summed-area table finds members in any rectangle, against a search") {
    Random random(5);
    const Grid grid = Grid::covering({{0, 0}, {17, 11}}, 1.0);
    for (int round = 0; round < 50; ++round) {
        CellSet cells;
        cells.reset(grid.count());
        for (std::uint32_t k = random.below(6); k > 0; --k)
            cells.insert(static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(grid.count()))));
        SummedAreaTable table;
        table.build(grid, cells);
        for (int k = 0; k < 200; ++k) {
            const Cell low{static_cast<std::int32_t>(random.below(20)) - 2,
                           static_cast<std::int32_t>(random.below(14)) - 2};
            const Cell high{low.x + static_cast<std::int32_t>(random.below(8)) - 1,
                            low.y + static_cast<std::int32_t>(random.below(8)) - 1};
            bool any = false;
            for (const std::int32_t cell : cells.members()) {
                const Cell c = grid.at(cell);
                any = any || (c.x >= low.x && c.x <= high.x && c.y >= low.y && c.y <= high.y);
            }
            CHECK(table.any({low, high}) == any);
        }
    }
}
