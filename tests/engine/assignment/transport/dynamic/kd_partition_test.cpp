#include "engine/assignment/transport/dynamic/kd_partition.h"

#include <doctest.h>

#include <algorithm>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::ascending;

TEST_CASE("leaves hold every point once, have even sizes, and do not depend on the order of the points") {
    Random random(5);
    std::vector<Vec2> points;
    for (int k = 0; k < 103; ++k) points.push_back({random.uniform(0.0, 30.0), random.uniform(0.0, 10.0)});
    for (const std::int32_t leaves : {1, 2, 3, 7, 16, 50}) {
        CAPTURE(leaves);
        std::vector<std::int32_t> order = ascending(points.size());
        std::vector<std::int32_t> ends;
        partitionIntoLeaves(points, order, leaves, 0, ends);
        REQUIRE(std::ssize(ends) == leaves);
        CHECK(ends.back() == 103);
        std::int32_t begin = 0, least = 1000, most = 0;
        for (const std::int32_t end : ends) {
            CHECK(std::is_sorted(order.begin() + begin, order.begin() + end));
            least = std::min(least, end - begin);
            most = std::max(most, end - begin);
            begin = end;
        }
        CHECK(most - least <= 2);
        std::vector<std::int32_t> backwards = ascending(points.size());
        std::reverse(backwards.begin(), backwards.end());
        std::vector<std::int32_t> again;
        partitionIntoLeaves(points, backwards, leaves, 0, again);
        CHECK(backwards == order);
        CHECK(again == ends);
        std::sort(order.begin(), order.end());
        CHECK(order == ascending(points.size()));
    }
}

TEST_CASE("a partition puts the lowest along the axis in front, those of equal coordinate by index") {
    const std::vector<Vec2> points{{3, 0}, {1, 0}, {1, 5}, {2, 0}, {1, 2}};
    std::vector<std::int32_t> order{4, 3, 2, 1, 0};
    partitionAlong(points, order, 2, true);
    std::sort(order.begin(), order.begin() + 2);
    CHECK(order[0] == 1);
    CHECK(order[1] == 2);
    CHECK_FALSE(isWide(points, ascending(points.size())));  // 2 m by 5 m.
    CHECK(isWide(points, std::vector<std::int32_t>{0, 1, 3}));
    std::vector<std::int32_t> none;
    partitionAlong(points, none, 0, true);
    CHECK(none.empty());
}
