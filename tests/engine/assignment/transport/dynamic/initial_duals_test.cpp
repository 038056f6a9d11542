#include "engine/assignment/transport/dynamic/initial_duals.h"

#include <doctest.h>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::ascending;
using muster_test::GraphFixture;

TEST_CASE("fitted duals leave little violated where the assignment is the optimum") {
    for (const std::uint64_t seed : {18, 19}) {
        GraphFixture fixture(400, seed, 12.0);
        // The crowd stands as the formation does, but half as large again: its own place is best for
        // everybody.
        for (std::size_t i = 0; i < 400; ++i)
            fixture.scene.costs.characters[i] = Vec2{-14.0, 3.0} + fixture.scene.costs.places[i] * 1.5;
        fixture.begin(ascending(400));
        fixture.rebuild();
        const double without = fixture.violations();
        InitialDuals().run(fixture.step(), fixture.graph);
        CHECK(without > 0.0);
        CHECK(fixture.violations() < 0.05 * without);
    }
}
