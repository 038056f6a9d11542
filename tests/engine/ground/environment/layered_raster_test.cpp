#include "engine/ground/environment/layered_raster.h"

#include <doctest.h>

#include <map>

#include "base/random.h"

using namespace muster;

namespace {

CellRect randomRect(const Grid& grid, Random& random) {
    const auto below = [&](std::int32_t bound) {
        return static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(bound)));
    };
    const Cell low{below(grid.width), below(grid.height)};
    return {low, {low.x + below(grid.width - low.x), low.y + below(grid.height - low.y)}};
}

bool holds(const CellRect& rect, Cell c) {
    return c.x >= rect.low.x && c.x <= rect.high.x && c.y >= rect.low.y && c.y <= rect.high.y;
}

/// A thing that lowers the values of its cells.
struct Thing {
    CellRect rect;
    float value;
};

/// Every cell by itself: the least value of the things that hold it.
std::vector<float> lowered(const Grid& grid, std::vector<float> values, const std::vector<Thing>& things) {
    for (const Thing& thing : things) {
        for (std::int32_t k = 0; k < grid.count(); ++k)
            if (holds(thing.rect, grid.at(k))) values[k] = std::min(values[k], thing.value);
    }
    return values;
}

std::vector<float> copy(std::span<const float> values) {
    return {values.begin(), values.end()};
}

std::vector<Thing> randomThings(const Grid& grid, Random& random) {
    std::vector<Thing> things(random.below(6));
    for (Thing& t : things) t = {randomRect(grid, random), static_cast<float>(random.uniform(-1, 12))};
    return things;
}

}  // namespace

TEST_CASE("moving things come and go, and the layers are what brute force makes of them") {
    Random random(61);
    for (int round = 0; round < 60; ++round) {
        const Grid grid{{0, 0},
                        1.0,
                        static_cast<std::int32_t>(1 + random.below(15)),
                        static_cast<std::int32_t>(1 + random.below(15))};
        LayeredRaster raster;
        raster.reset(grid, 10.0f);
        CHECK(raster.fixed().empty());
        CHECK(raster.combinedView().isConstant());
        CHECK(raster.fixedView()[grid.count() - 1] == 10.0f);
        raster.allocate();
        std::vector<float> fixed(grid.count(), 10.0f);
        CHECK(copy(raster.fixed()) == fixed);
        CHECK(copy(raster.combined()) == fixed);
        const auto walls = randomThings(grid, random);
        for (const Thing& wall : walls) raster.lowerFixed(wall.rect, [&](Cell, float) { return wall.value; });
        fixed = lowered(grid, fixed, walls);
        CHECK(copy(raster.fixed()) == fixed);
        raster.restoreFixed({{0, 0}, {grid.width - 1, grid.height - 1}});
        CHECK(copy(raster.combined()) == fixed);
        std::size_t before = 0;
        for (int step = 0; step < 8; ++step) {
            CHECK(raster.removeMoving().size() == before);
            CHECK(copy(raster.combined()) == fixed);
            CHECK(raster.movingAreas().empty());
            const auto things = randomThings(grid, random);
            for (const Thing& t : things) raster.lowerCombined(t.rect, [&](Cell, float) { return t.value; });
            CHECK(copy(raster.combined()) == lowered(grid, fixed, things));
            CHECK(copy(raster.fixed()) == fixed);
            CHECK(raster.movingAreas().size() == things.size());
            before = things.size();
        }
        raster.removeMoving();
        raster.dropCombined();
        CHECK(raster.combined().data() == raster.fixed().data());
    }
}

TEST_CASE("the order of things does not matter") {
    Random random(62);
    const Grid grid{{0, 0}, 1.0, 12, 9};
    for (int round = 0; round < 30; ++round) {
        auto things = randomThings(grid, random);
        std::vector<std::vector<float>> results;
        for (int order = 0; order < 2; ++order) {
            LayeredRaster raster;
            raster.reset(grid, 5.0f);
            for (const Thing& t : things) raster.lowerCombined(t.rect, [&](Cell, float) { return t.value; });
            results.push_back(copy(raster.combined()));
            std::reverse(things.begin(), things.end());
        }
        CHECK(results[0] == results[1]);
    }
}

TEST_CASE("each cell of a rectangle is visited once with its value so far, and others are not") {
    const Grid grid{{0, 0}, 1.0, 6, 5};
    LayeredRaster raster;
    raster.reset(grid, 0.0f);
    const auto number = [&](Cell c) { return static_cast<float>(grid.index(c)); };
    raster.setFixed({{0, 0}, {5, 4}}, number);
    raster.restoreFixed({{0, 0}, {5, 4}});
    std::map<std::int32_t, int> visits;
    const CellRect rect{{2, 1}, {4, 3}};
    const auto visit = [&](Cell c, float value) {
        CHECK(value == number(c));
        CHECK(holds(rect, c));
        ++visits[grid.index(c)];
        return value - 0.5f;
    };
    raster.lowerCombined(rect, visit);
    CHECK(visits.size() == 9);
    for (const auto& [cell, count] : visits) CHECK(count == 1);
    for (std::int32_t k = 0; k < grid.count(); ++k)
        CHECK(raster.combined()[k] == static_cast<float>(k) - (holds(rect, grid.at(k)) ? 0.5f : 0.0f));
    // What removeMoving() returns is where things were, to the cell.
    const auto removed = raster.removeMoving();
    REQUIRE(removed.size() == 1);
    CHECK(removed[0].low == rect.low);
    CHECK(removed[0].high == rect.high);
    // An empty rectangle is no area, and values are never raised.
    raster.lowerCombined(CellRect{}, visit);
    raster.restoreFixed(CellRect{});
    CHECK(raster.movingAreas().empty());
    raster.lowerCombined(rect, [](Cell, float value) { return value + 1.0f; });
    CHECK(copy(raster.combined()) == copy(raster.fixed()));
}
