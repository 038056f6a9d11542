// The numbers of ways.
#include <doctest.h>

#include <set>

#include "engine/passages/way_number.h"

using namespace muster;

TEST_CASE("each way has its own number below the count, which tells its passage and side") {
    std::set<std::int32_t> numbers;
    for (std::int32_t passage = 0; passage < 5; ++passage)
        for (const std::int32_t side : {-1, 1}) {
            const std::int32_t way = wayNumber(passage, side);
            CHECK(passageOf(way) == static_cast<std::size_t>(passage));
            CHECK(sideBefore(way) == side);
            CHECK(sideBehind(way) == -side);
            CHECK(fromLeft(way) == (side == 1));
            numbers.insert(way);
        }
    CHECK(numbers.size() == wayCount(5));
    CHECK(*numbers.begin() == 0);
    CHECK(*numbers.rbegin() == static_cast<std::int32_t>(wayCount(5)) - 1);
}
