#include "engine/assignment/transport/dynamic/exchange_graph.h"

#include <doctest.h>

#include <algorithm>

#include "engine/assignment/transport/dynamic/graph_fixture.h"

using namespace muster;
using muster_test::ascending;
using muster_test::GraphFixture;
using muster_test::kArcsPerNode;

namespace {

std::int32_t nearestPlace(const AssignmentInput& input, std::int32_t place) {
    std::int32_t nearest = -1;
    double least = kInfiniteCost;
    for (std::int32_t j = 0; j < std::ssize(input.places); ++j) {
        const double d = lengthSquared(input.places[j] - input.places[place]);
        if (j == place || !(d < least)) continue;
        least = d;
        nearest = j;
    }
    return nearest;
}

}  // namespace

TEST_CASE("arcs lead to several near nodes, once each, and cost what a move changes in the objective") {
    GraphFixture fixture(120, 21);
    fixture.begin(ascending(120));
    fixture.rebuild();
    const ExchangeArcs& arcs = fixture.graph.arcs();
    const auto power = [&](std::int32_t i, std::int32_t j) {
        return fixture.step().power(fixture.scene.costs.cost(i, j));
    };
    for (std::int32_t node = 0; node < 120; ++node) {
        std::vector<std::int32_t> heads;
        for (std::int32_t arc = node * kArcsPerNode; arc < (node + 1) * kArcsPerNode; ++arc) {
            const std::int32_t head = arcs.head(arc);
            if (head == node) {
                CHECK(arcs.cost(arc) == ExchangeArcs::kSelfLoopCost);
                continue;
            }
            heads.push_back(head);
            const auto& places = fixture.input.places;
            const double shift = dot(fixture.step().dualSlope, places[head] - places[node]);
            CHECK(arcs.cost(arc) ==
                  doctest::Approx(power(node, head) - power(node, node) - shift).epsilon(1e-5));
            CHECK(arcs.find(node, head) == arc);
        }
        std::sort(heads.begin(), heads.end());
        CHECK(std::adjacent_find(heads.begin(), heads.end()) == heads.end());
        CHECK(heads.size() >= 8);
        CHECK(std::binary_search(heads.begin(), heads.end(), nearestPlace(fixture.input, node)));
    }
}

TEST_CASE("the index of incoming arcs holds every arc once, at its head, ascending") {
    GraphFixture fixture(120, 22);
    fixture.begin(ascending(120));
    fixture.rebuild();
    std::size_t sum = 0;
    for (std::int32_t node = 0; node < 120; ++node) {
        const auto incoming = fixture.graph.arcs().incoming(node);
        sum += incoming.size();
        CHECK(std::is_sorted(incoming.begin(), incoming.end()));
        for (const std::int32_t arc : incoming) CHECK(fixture.graph.arcs().head(arc) == node);
    }
    CHECK(sum == 120 * kArcsPerNode);
}

TEST_CASE("the least reduced cost of a node is that of its most violated arc, to the bit") {
    GraphFixture fixture(120, 16);
    fixture.disturb(17, 3.0, false);
    for (std::int32_t node = 0; node < 120; ++node) {
        double least = kInfiniteCost;
        for (std::int32_t arc = node * kArcsPerNode; arc < (node + 1) * kArcsPerNode; ++arc)
            least = std::min(least, fixture.graph.reducedCost(arc));
        REQUIRE(fixture.graph.leastReducedCost(node) == least);
        REQUIRE(fixture.graph.reducedCost(fixture.graph.mostViolatedArc(node)) == least);
    }
}

TEST_CASE("an arc is found in whatever slot it is, and none where there is none") {
    GraphFixture fixture(120, 18);
    fixture.disturb(19, 1.0, false);
    const ExchangeArcs& arcs = fixture.graph.arcs();
    for (std::int32_t tail = 0; tail < 120; ++tail)
        for (std::int32_t head = 0; head < 120; ++head) {
            std::int32_t first = -1;
            for (std::int32_t arc = (tail + 1) * kArcsPerNode; arc-- > tail * kArcsPerNode;)
                if (arcs.head(arc) == head) first = arc;
            REQUIRE(arcs.find(tail, head) == first);
        }
}

TEST_CASE("a refresh between full ones evaluates tight arcs only, and the others keep their costs") {
    GraphFixture fixture(120, 20);
    fixture.disturb(21, 3.0, false);
    fixture.def.invalidatingChange = 10.0;
    for (Vec2& p : fixture.scene.costs.characters) p += Vec2{0.3, -0.2};
    fixture.begin();
    const std::vector<float> before = fixture.graph.arcs().costs();
    const std::vector<double> reduced = fixture.reducedCosts();
    RefreshSchedule schedule;
    schedule.round = 1000000;  // Its refreshes are no full ones, and no heads are due.
    schedule.beginsRound = false;
    schedule.end = 120;
    schedule.candidatePeriod = 1 << 30;
    REQUIRE_FALSE(schedule.allArcsDue(1));
    fixture.graph.refreshArcs(fixture.step(), schedule);
    int evaluated = 0;
    for (std::int32_t arc = 0; arc < 120 * kArcsPerNode; ++arc) {
        const std::int32_t tail = ExchangeArcs::tail(arc);
        const std::int32_t head = fixture.graph.arcs().head(arc);
        if (head == tail || schedule.allArcsDue(tail)) continue;
        const double matched = std::max(1.0, static_cast<double>(fixture.graph.matchedCost(tail)));
        const double margin = fixture.step().power(matched + 0.2) - fixture.step().power(matched);
        const double costAtHead = fixture.step().power(fixture.scene.costs.cost(tail, head));
        const double now = fixture.graph.arcCost(fixture.step(), tail, head, costAtHead);
        const bool tight = reduced[arc] < margin;
        REQUIRE(fixture.graph.arcs().cost(arc) == (tight ? static_cast<float>(now) : before[arc]));
        evaluated += tight ? 1 : 0;
    }
    CHECK(evaluated > 100);
    CHECK(evaluated < 120 * 12);
}

TEST_CASE("expensive nodes have arcs to each other, however far they are") {
    GraphFixture fixture(120, 23);
    for (const std::int32_t i : {0, 119})
        fixture.scene.costs.characters[i] += Vec2{i == 0 ? -60.0 : 60.0, 0.0};
    fixture.begin(ascending(120));
    fixture.rebuild();
    CHECK(fixture.graph.expensiveNodes() == std::vector<std::int32_t>{0, 119});
    CHECK(fixture.graph.arcs().find(0, 119) >= 0);
    CHECK(fixture.graph.arcs().find(119, 0) >= 0);
}
