// A sparse raster holds what a dense one would.
#include "base/sparse_raster.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

TEST_CASE("a sparse raster reads as a dense one through many rounds, and keeps its memory") {
    Random random(3);
    const Grid grid{{0, 0}, 1.0, 300, 210};
    SparseRaster<float> sparse;
    sparse.reset(grid);
    CHECK(sparse.tiles() == 1);
    const auto anyCell = [&](std::int32_t right, std::int32_t top) {
        return Cell{static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(right))),
                    static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(top)))};
    };
    std::size_t most = 0;
    for (int round = 0; round < 20; ++round) {
        std::vector<float> dense(grid.count(), 0.0f);
        for (int k = 0; k < 200; ++k) {
            // Round after round in other places.
            const Cell low = anyCell(40, 40);
            const Cell c{low.x + 12 * round, low.y + 8 * round};
            const auto value = static_cast<float>(random.uniform(-1, 1));
            sparse.touch(c) += value;
            dense[grid.index(c)] += value;
        }
        for (std::int32_t k = 0; k < grid.count(); ++k) REQUIRE(sparse[grid.at(k)] == dense[k]);
        for (int k = 0; k < 2000; ++k) {
            const Cell low = anyCell(grid.width - 1, grid.height - 1);
            const Cell high{low.x + 1, low.y + static_cast<std::int32_t>(random.below(2))};
            const auto [value] = sparse.square(low, high);
            REQUIRE(value[0] == dense[grid.index(low)]);
            REQUIRE(value[1] == dense[grid.index({high.x, low.y})]);
            REQUIRE(value[2] == dense[grid.index({low.x, high.y})]);
            REQUIRE(value[3] == dense[grid.index(high)]);
        }
        sparse.clear();
        for (std::int32_t k = 0; k < grid.count(); ++k) REQUIRE(sparse[grid.at(k)] == 0.0f);
        most = std::max(most, sparse.tiles());
    }
    CHECK(most <= 10);  // Not the 70 tiles of the grid.
}
