#include "engine/ground/environment/box_grid.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

using namespace muster;

namespace {

Box randomBox(const Box& world, double largest, Random& random) {
    const Box wide = world.grown(largest);
    const Vec2 corner{random.uniform(wide.min.x, wide.max.x), random.uniform(wide.min.y, wide.max.y)};
    return {corner, corner + Vec2{random.uniform(0, largest), random.uniform(0, largest)}};
}

Vec2 pointIn(const Box& box, Random& random) {
    return {random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y)};
}

/// Distance between a point and a box along the axis where it is larger [m].
double separation(const Box& box, Vec2 p) {
    const Vec2 d = p - box.clamp(p);
    return std::max(std::fabs(d.x), std::fabs(d.y));
}

}  // namespace

TEST_CASE("every box that holds a point is found in its cell, and none that is a cell away") {
    Random random(6);
    BoxGrid grid;
    for (int round = 0; round < 40; ++round) {
        const Vec2 corner{random.uniform(-50, 50), random.uniform(-50, 50)};
        const double size = round % 4 == 0 ? 3000.0 : 30.0;
        const Box world{corner, corner + Vec2{size, random.uniform(1.0, size)}};
        // Cells are at least 2 m wide, and at most 512 lie across.
        const double cell = std::max(2.0, size / 512.0);
        grid.reset(world);
        std::vector<Box> boxes(random.below(60));
        for (Box& box : boxes) box = randomBox(world, 0.3 * size, random);
        std::vector<std::int32_t> items;
        for (std::int32_t i = 0; i < std::ssize(boxes); ++i)
            if (random.below(3) != 0) items.push_back(i);
        grid.fill(boxes, items);
        for (int i = 0; i < 100; ++i) {
            const Vec2 p = pointIn(world, random);
            const auto found = grid.at(p);
            CHECK(std::is_sorted(found.begin(), found.end()));
            CHECK(std::adjacent_find(found.begin(), found.end()) == found.end());
            for (const std::int32_t item : items) {
                const bool listed = std::find(found.begin(), found.end(), item) != found.end();
                if (boxes[item].contains(p)) CHECK(listed);
                if (separation(boxes[item], p) > cell) CHECK(!listed);
            }
            for (const std::int32_t item : found) CHECK(std::binary_search(items.begin(), items.end(), item));
        }
    }
}

TEST_CASE("a refill forgets what was there, and a box outside the world is nowhere") {
    const Box world{{0, 0}, {20, 20}};
    const std::vector<Box> boxes{
        {{1, 1}, {3, 3}}, {{10, 10}, {19, 12}}, {{-9, -9}, {-5, 30}}, {{-5, -5}, {40, 40}}};
    const auto total = [&](const BoxGrid& grid) {
        std::size_t sum = 0;
        for (double y = 1; y < 20; y += 2)
            for (double x = 1; x < 20; x += 2) sum += grid.at({x, y}).size();
        return sum;
    };
    BoxGrid grid;
    grid.reset(world);
    CHECK(total(grid) == 0);
    grid.fill(boxes, std::vector<std::int32_t>{2});
    CHECK(total(grid) == 0);
    grid.fill(boxes, std::vector<std::int32_t>{3});
    CHECK(total(grid) == 100);
    grid.fill(boxes, std::vector<std::int32_t>{0});
    CHECK(total(grid) == 4);  // From x = 1 to 3 lie two cells, and as many along y.
    grid.fill(boxes, std::vector<std::int32_t>{0, 3});
    CHECK(total(grid) == 104);
    CHECK(grid.at({2, 2}).size() == 2);
    grid.fill(boxes, {});
    CHECK(total(grid) == 0);
    grid.fill(boxes, std::vector<std::int32_t>{1});
    grid.reset(world);
    CHECK(total(grid) == 0);
}

TEST_CASE("inserted, removed and renumbered boxes are found as after a refill") {
    Random random(7);
    for (int round = 0; round < 20; ++round) {
        const Box world{{-20, -10}, {20, 15}};
        BoxGrid grid, refilled;
        grid.reset(world);
        refilled.reset(world);
        std::vector<Box> boxes(20);
        std::vector<std::int32_t> items;
        for (Box& box : boxes) box = randomBox(world, 12.0, random);
        for (std::int32_t i = 0; i < 10; ++i) items.push_back(i);
        grid.fill(boxes, items);
        for (int edit = 0; edit < 60; ++edit) {
            const auto at = random.below(static_cast<std::uint32_t>(boxes.size()));
            const auto item = static_cast<std::int32_t>(at);
            const auto where = std::lower_bound(items.begin(), items.end(), item);
            if (where == items.end() || *where != item) {
                items.insert(where, item);
                grid.insert(boxes[at], item);
            } else if (random.below(3) == 0) {
                // It goes, and those behind it move up.
                items.erase(where);
                grid.remove(boxes[at], item);
                for (std::int32_t& other : items) other -= other > item ? 1 : 0;
                grid.renumber(item + 1, -1);
                boxes.erase(boxes.begin() + item);
                boxes.push_back(randomBox(world, 12.0, random));
            } else {
                items.erase(where);
                grid.remove(boxes[at], item);
                boxes[at] = randomBox(world, 12.0, random);
            }
            refilled.fill(boxes, items);
            for (int i = 0; i < 40; ++i) {
                const Vec2 p = pointIn(world, random);
                const auto found = grid.at(p), expected = refilled.at(p);
                REQUIRE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
            }
        }
    }
}
