#include "engine/assignment/transport/dynamic/nearest_points.h"

#include <doctest.h>

#include <algorithm>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::ascending;

namespace {

// By comparing all of them.
std::vector<std::int32_t> nearestOfAll(const std::vector<Vec2>& points, Vec2 centre, std::int32_t count,
                                       bool even) {
    std::vector<std::int32_t> order = ascending(points.size());
    if (even) std::erase_if(order, [](std::int32_t p) { return p % 2 != 0; });
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        const double da = lengthSquared(points[a] - centre);
        const double db = lengthSquared(points[b] - centre);
        return da != db ? da < db : a < b;
    });
    order.resize(std::min<std::size_t>(order.size(), count));
    return order;
}

}  // namespace

TEST_CASE("the nearest points are those that a comparison of all finds") {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        Random scatter(seed);
        const double height = seed % 2 == 0 ? 3.0 : 25.0;
        std::vector<Vec2> points;
        for (int k = 0; k < 400; ++k)
            points.push_back({scatter.uniform(0.0, 20.0), scatter.uniform(0.0, height)});
        CellList cells;
        cells.sort(points, 1.1);
        Random random(seed + 10);
        for (int trial = 0; trial < 60; ++trial) {
            const Vec2 centre{random.uniform(-4.0, 24.0), random.uniform(-4.0, 28.0)};
            const std::int32_t count = 1 + static_cast<std::int32_t>(random.below(8));
            const bool even = trial % 3 == 0;
            NearestPoints near;
            near.find(cells, points, centre, count, [&](std::int32_t p) { return !even || p % 2 == 0; });
            const std::vector<std::int32_t> expected = nearestOfAll(points, centre, count, even);
            REQUIRE(near.size() == std::ssize(expected));
            for (std::int32_t k = 0; k < near.size(); ++k) REQUIRE(near[k] == expected[k]);
        }
    }
    NearestPoints none;
    none.find(CellList(), {}, {0, 0}, 4, [](std::int32_t) { return true; });
    CHECK(none.size() == 0);
}

TEST_CASE("of equally near points the lower index comes first") {
    const std::vector<Vec2> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    CellList cells;
    cells.sort(points, 0.5);
    NearestPoints near;
    near.find(cells, points, {0, 0}, 3, [](std::int32_t) { return true; });
    REQUIRE(near.size() == 3);
    CHECK(near[0] < near[1]);
    CHECK(near[1] < near[2]);
    near.find(cells, points, {0, 0}, 5, [](std::int32_t) { return true; });
    for (std::int32_t k = 0; k < 5; ++k) CHECK(near[k] == k);
}
