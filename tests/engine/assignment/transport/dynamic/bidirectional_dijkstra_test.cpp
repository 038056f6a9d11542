#include "engine/assignment/transport/dynamic/bidirectional_dijkstra.h"

#include <doctest.h>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::GraphFixture;
using muster_test::kArcsPerNode;

namespace {

double lengthOf(const ExchangeGraph& graph, std::span<const std::int32_t> path) {
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        const std::int32_t arc = graph.arcs().find(path[k], path[k + 1]);
        REQUIRE(arc >= 0);
        sum += std::max(graph.reducedCost(arc), 0.0);
    }
    return sum;
}

}  // namespace

TEST_CASE("a search finds the shortest path back, or shows that none is shorter than the violation") {
    int cycles = 0, none = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        GraphFixture fixture(90, seed);
        fixture.disturb(seed + 40, 1.5, seed > 3);
        const ExchangeGraph& graph = fixture.graph;
        BidirectionalDijkstra search;
        search.reset(90, 100000);
        for (std::int32_t arc = 0; arc < 90 * kArcsPerNode; arc += 7) {
            const std::int32_t tail = ExchangeArcs::tail(arc);
            const std::int32_t head = graph.arcs().head(arc);
            const double violation = -graph.reducedCost(arc);
            if (head == tail || !(violation > 0.0)) continue;
            const double shortest = fixture.distancesFrom(head)[tail];
            const SearchResult result = search.run(graph.arcs(), graph.duals(), tail, head, violation,
                                                   kInfiniteCost, 100000);
            if (shortest < violation) {
                REQUIRE(result == SearchResult::Cycle);
                CHECK(search.cycle().front() == head);
                CHECK(search.cycle().back() == tail);
                CHECK(lengthOf(graph, search.cycle()) == doctest::Approx(shortest).epsilon(1e-9));
                ++cycles;
            } else {
                REQUIRE(result == SearchResult::NoCycle);
                ++none;
            }
        }
    }
    CHECK(cycles > 30);
    CHECK(none > 30);
}

TEST_CASE("an update of duals repairs the arc, and hardly ever violates another or lowers a violated one") {
    for (const std::uint64_t seed : {7, 8, 9}) {
        GraphFixture fixture(90, seed);
        fixture.disturb(seed + 40, 0.8, true);
        ExchangeGraph& graph = fixture.graph;
        BidirectionalDijkstra search;
        search.reset(90, 40);
        Random random(seed);
        int repaired = 0, limited = 0;
        int broken = 0;  // Arcs to nodes that a search dropped beyond its bound.
        for (int trial = 0; trial < 400; ++trial) {
            const auto arc = static_cast<std::int32_t>(random.below(90 * kArcsPerNode));
            const std::int32_t tail = ExchangeArcs::tail(arc);
            const std::int32_t head = graph.arcs().head(arc);
            const double violation = -graph.reducedCost(arc);
            if (head == tail || !(violation > 1e-6)) continue;
            const std::vector<double> before = fixture.reducedCosts();
            const std::int32_t limit = trial % 2 == 0 ? 4 : 40;
            const SearchResult result = search.run(graph.arcs(), graph.duals(), tail, head, violation,
                                                   kInfiniteCost, limit);
            search.updateDuals(graph.duals());
            const std::vector<double> after = fixture.reducedCosts();
            for (std::size_t k = 0; k < before.size(); ++k)
                if (before[k] < kInfiniteCost && after[k] < std::min(before[k], 0.0) - 1e-9) ++broken;
            if (result == SearchResult::NoCycle) {
                CHECK(graph.reducedCost(arc) >= -1e-9);
                ++repaired;
            }
            limited += result == SearchResult::LimitReached ? 1 : 0;
            CHECK(search.settled() <= limit + 1);
        }
        CHECK(repaired > 10);
        CHECK(limited > 0);
        CHECK(broken <= 2);
    }
}

TEST_CASE("a return arc of length zero closes the cycle at once") {
    GraphFixture fixture(60, 12);
    fixture.disturb(13, 1.0, false);
    const ExchangeGraph& graph = fixture.graph;
    BidirectionalDijkstra search;
    search.reset(60, 1000);
    for (std::int32_t arc = 0; arc < 60 * kArcsPerNode; arc += 11) {
        const std::int32_t tail = ExchangeArcs::tail(arc);
        const std::int32_t head = graph.arcs().head(arc);
        const double violation = -graph.reducedCost(arc);
        if (head == tail || !(violation > 0.0)) continue;
        REQUIRE(search.run(graph.arcs(), graph.duals(), tail, head, violation, 0.0, 1000) ==
                SearchResult::Cycle);
        REQUIRE(search.cycle().size() == 2);
        CHECK(search.cycle()[0] == head);
        CHECK(search.cycle()[1] == tail);
    }
}
