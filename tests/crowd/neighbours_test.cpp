#include "crowd/neighbours.h"

#include <doctest.h>

#include <algorithm>
#include <set>

#include "base/random.h"

using namespace muster;

TEST_CASE("all close pairs are found, once each, as by comparing everyone with everyone") {
    Random random(5);
    NeighbourGrid grid;
    std::vector<NearPair> pairs;
    for (int scene = 0; scene < 200; ++scene) {
        std::vector<Vec2> positions(1 + random.below(120));
        const double size = scene % 3 == 0 ? 2.0 : 40.0;
        for (Vec2& p : positions) p = {random.uniform(-size, size), random.uniform(-size, size)};
        if (scene % 5 == 0) positions.push_back({1e5, -1e5});
        const double reach = random.uniform(0.05, 1.5);
        grid.findPairs(positions, reach, pairs);
        std::set<std::pair<int, int>> found;
        for (const NearPair pair : pairs) {
            CHECK(pair.a < pair.b);
            CHECK(found.insert({pair.a, pair.b}).second);
        }
        std::set<std::pair<int, int>> expected;
        for (int i = 0; i < static_cast<int>(positions.size()); ++i)
            for (int j = i + 1; j < static_cast<int>(positions.size()); ++j)
                if (lengthSquared(positions[j] - positions[i]) < reach * reach) expected.insert({i, j});
        CHECK(found == expected);
    }
}

TEST_CASE("no one and one alone have no neighbours") {
    NeighbourGrid grid;
    std::vector<NearPair> pairs(3);
    grid.findPairs({}, 1.0, pairs);
    CHECK(pairs.empty());
    const std::vector<Vec2> one{{1, 1}};
    grid.findPairs(one, 1.0, pairs);
    CHECK(pairs.empty());
}
