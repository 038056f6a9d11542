#include "engine/steering/near_rows.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

TEST_CASE("rows hold the pairs of each character in their order, seen from either side") {
    Random random(31);
    std::vector<Vec2> positions(60);
    for (Vec2& p : positions) p = {random.uniform(-3, 3), random.uniform(-3, 3)};
    positions[7] = positions[4];
    NeighbourList list;
    list.build(positions, 1.5);
    const CrowdBodies bodies;
    NearRows rows;
    rows.build(bodies, positions, list.pairs());
    std::vector<std::size_t> read(positions.size(), 0);
    for (const NeighbourPair pair : list.pairs()) {
        CHECK(rows.of(pair.low)[read[pair.low]++] == pair.high);
        CHECK(rows.of(pair.high)[read[pair.high]++] == pair.low);
        const Near near = rows.near(pair.low, pair.high), back = rows.near(pair.high, pair.low);
        const double apart = distance(positions[pair.low], positions[pair.high]);
        CHECK(near.other == pair.high);
        CHECK(back.other == pair.low);
        CHECK(near.gap == apart - bodies.touching(pair.low, pair.high));
        CHECK(back.gap == near.gap);
        CHECK(back.towards == -near.towards);
        CHECK(length(near.towards) == doctest::Approx(1.0));
        CHECK(distance(positions[pair.low] + near.towards * apart, positions[pair.high]) < 1e-12);
    }
    for (std::size_t i = 0; i < positions.size(); ++i)
        CHECK(rows.of(static_cast<std::int32_t>(i)).size() == read[i]);
}
