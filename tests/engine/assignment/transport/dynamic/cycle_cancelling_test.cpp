#include "engine/assignment/transport/dynamic/cycle_cancelling.h"

#include <doctest.h>

#include <algorithm>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::ascending;
using muster_test::GraphFixture;

TEST_CASE("repairs only lower the objective, within their budget, and end where nothing gains enough") {
    for (const std::uint64_t seed : {14, 15}) {
        GraphFixture fixture(200, seed);
        std::vector<std::int32_t> shuffled = ascending(200);
        for (std::int32_t i = 199; i > 0; --i)
            std::swap(shuffled[i], shuffled[fixture.scene.random.below(i + 1)]);
        fixture.begin(shuffled);
        fixture.rebuild();
        const auto objective = [&] {
            const auto powers = fixture.graph.matchedPowers();
            return std::accumulate(powers.begin(), powers.end(), 0.0);
        };
        CycleCancelling cancelling;
        cancelling.reset(200, fixture.def.searchLimit);
        double before = objective();
        const double first = before;
        for (int round = 0; round < 300; ++round) {
            cancelling.run(fixture.step(), fixture.graph, 600, 16);
            CHECK(cancelling.settled() <= 600 + 3);
            const double now = objective();
            CHECK(now <= before + 1e-9);
            before = now;
            fixture.rebuild();
        }
        CHECK(before < 0.1 * first);
        CHECK(before < 1.05 * fixture.scene.optimum(2.0) + 1.0);
        // Nobody lost a place, and no two have the same.
        std::vector<int> taken(200, 0);
        for (std::int32_t i = 0; i < 200; ++i) ++taken[fixture.graph.nodes().nodeOf(i)];
        CHECK(std::all_of(taken.begin(), taken.end(), [](int n) { return n == 1; }));
    }
}
