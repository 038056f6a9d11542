#include "engine/assignment/transport/dynamic/initial_assignment.h"

#include <doctest.h>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::GraphFixture;

TEST_CASE("a few characters are matched greedily, nearest pair first") {
    GraphFixture few(12, 16);
    few.begin();
    double shortest = kInfiniteCost;
    std::int32_t character = -1, place = -1;
    for (std::int32_t i = 0; i < 12; ++i)
        for (std::int32_t j = 0; j < 12; ++j) {
            if (!(few.scene.costs.exact(i, j) < shortest)) continue;
            shortest = few.scene.costs.exact(i, j);
            character = i;
            place = j;
        }
    CHECK(few.graph.nodes().nodeOf(character) == place);
    for (std::int32_t i = 0; i < 12; ++i) CHECK(few.graph.nodes().nodeOf(i) >= 0);
}

TEST_CASE("many characters are matched near the optimum") {
    for (const double away : {40.0, 8.0}) {
        GraphFixture many(700, 17, away);
        many.begin();
        double sum = 0.0;
        for (std::int32_t i = 0; i < 700; ++i) {
            const std::int32_t place = many.graph.nodes().nodeOf(i);
            REQUIRE(place >= 0);
            sum += many.scene.costs.exact(i, place) * many.scene.costs.exact(i, place);
        }
        CHECK(sum < (away > 20.0 ? 1.01 : 1.1) * many.scene.optimum(2.0));
    }
}
