#include "base/summed_area_table.h"

#include <doctest.h>

#include "base/bounds.h"
#include "base/random.h"

using namespace muster;

namespace {

bool bruteAny(const Grid& grid, const CellSet& cells, const CellRect& rect) {
    for (const std::int32_t cell : cells.members()) {
        const Cell c = grid.at(cell);
        if (c.x >= rect.low.x && c.x <= rect.high.x && c.y >= rect.low.y && c.y <= rect.high.y) return true;
    }
    return false;
}

std::int32_t between(Random& random, std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

}  // namespace

TEST_CASE("rectangles that hold members are found as brute force finds them") {
    Random random(17);
    SummedAreaTable table;
    CellSet cells;
    for (int round = 0; round < 60; ++round) {
        const Grid grid{{0, 0}, 1.0, between(random, 1, 30), between(random, 1, 30)};
        cells.reset(grid.count());
        const std::int32_t members = between(random, 0, 12);
        for (std::int32_t i = 0; i < members; ++i) cells.insert(between(random, 0, grid.count() - 1));
        table.build(grid, cells);
        for (int i = 0; i < 200; ++i) {
            // Rectangles reach beyond the grid, and some are empty.
            const CellRect rect{{between(random, -4, grid.width + 3), between(random, -4, grid.height + 3)},
                                {between(random, -4, grid.width + 3), between(random, -4, grid.height + 3)}};
            CHECK(table.any(rect) == (!rect.empty() && bruteAny(grid, cells, rect)));
        }
        CHECK(table.any({{0, 0}, {grid.width - 1, grid.height - 1}}) == (members > 0));
    }
}

TEST_CASE("the common part of two rectangles holds the cells that both hold") {
    Random random(23);
    for (int round = 0; round < 300; ++round) {
        const auto any = [&] {
            return CellRect{{between(random, 0, 6), between(random, 0, 6)},
                            {between(random, 0, 6), between(random, 0, 6)}};
        };
        const auto holds = [](const CellRect& r, std::int32_t x, std::int32_t y) {
            return x >= r.low.x && x <= r.high.x && y >= r.low.y && y <= r.high.y;
        };
        const CellRect a = any(), b = any(), both = a.common(b);
        std::int32_t count = 0;
        for (std::int32_t y = -1; y <= 7; ++y) {
            for (std::int32_t x = -1; x <= 7; ++x) {
                CHECK(holds(both, x, y) == (holds(a, x, y) && holds(b, x, y)));
                count += holds(both, x, y) ? 1 : 0;
            }
        }
        CHECK(both.empty() == (count == 0));
    }
    CHECK(CellRect{}.empty());
}

TEST_CASE("a box touches the cells that it overlaps, as far as they are on the grid") {
    Random random(29);
    for (int round = 0; round < 200; ++round) {
        const Grid grid{{random.uniform(-5, 5), random.uniform(-5, 5)},
                        random.uniform(0.2, 2.0),
                        between(random, 1, 12),
                        between(random, 1, 12)};
        const Vec2 a{random.uniform(-20, 20), random.uniform(-20, 20)};
        const Box box{a, a + Vec2{random.uniform(0, 15), random.uniform(0, 15)}};
        const CellRect rect = CellRect::touching(grid, box);
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            const Cell c = grid.at(k);
            const Vec2 half{0.5 * grid.cell, 0.5 * grid.cell}, low = grid.centre(c) - half,
                                                               high = grid.centre(c) + half;
            const bool overlaps = low.x <= box.max.x && box.min.x <= high.x && low.y <= box.max.y &&
                                  box.min.y <= high.y;
            const bool inside = c.x >= rect.low.x && c.x <= rect.high.x && c.y >= rect.low.y &&
                                c.y <= rect.high.y;
            CHECK(inside == overlaps);
        }
    }
}

TEST_CASE("bounds hold all points and no smaller box does") {
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        std::vector<Vec2> points(1 + random.below(20));
        for (Vec2& p : points) p = {random.uniform(-9, 9), random.uniform(-9, 9)};
        const Box box = boundsOf(points);
        bool left = false, right = false, low = false, high = false;
        for (const Vec2 p : points) {
            CHECK(box.contains(p));
            left = left || p.x == box.min.x;
            right = right || p.x == box.max.x;
            low = low || p.y == box.min.y;
            high = high || p.y == box.max.y;
        }
        CHECK((left && right && low && high));
    }
}
