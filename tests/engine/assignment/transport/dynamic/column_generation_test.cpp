// Column generation: arcs that the sparse graph lacks, between nodes that are far in metres and near by cost.
#include <doctest.h>

#include "engine/assignment/transport/dynamic/assignment_scene.h"
#include "engine/assignment/transport/dynamic/graph_fixture.h"

namespace {

using muster::DynamicAssignment;
using muster::Vec2;

// Straight distances, but for pairs joined by a tunnel.
class TunnelCosts final : public muster_test::WallCosts {
public:
    std::vector<muster::AssignmentPair> tunnels;
    double length = 0.2;

    double exact(std::size_t i, std::size_t j) const override {
        for (const muster::AssignmentPair& t : tunnels)
            if (t.character == static_cast<std::int32_t>(i) && t.place == static_cast<std::int32_t>(j))
                return length;
        return WallCosts::exact(i, j);
    }
    double leastUnitCost() const override { return 0.0; }
};

// A block of 400 who stand a metre off their places; a dozen have tunnels to places at the other end.
struct TunnelScene {
    TunnelCosts costs;
    std::vector<std::int32_t> placeOf;

    TunnelScene() {
        for (std::int32_t k = 0; k < 400; ++k) {
            costs.places.push_back({static_cast<double>(k % 20), static_cast<double>(k / 20)});
            costs.characters.push_back(costs.places.back() + Vec2{1.0, 0.01 * (k % 7)});
            placeOf.push_back(k);
        }
        // In both directions, so that an exchange of two gains: 2 - 0.08 square metres each.
        for (std::int32_t k = 0; k < 12; ++k) {
            costs.tunnels.push_back({k, 399 - k});
            costs.tunnels.push_back({399 - k, k});
        }
    }
    muster::AssignmentInput input() const { return {costs.characters, costs.places, {}, {}}; }
    double optimum() const {
        std::vector<double> matrix;
        for (std::size_t i = 0; i < 400; ++i)
            for (std::size_t j = 0; j < 400; ++j) matrix.push_back(costs.exact(i, j) * costs.exact(i, j));
        return muster_test::leastSum(400, 400, matrix);
    }
};

muster::DynamicAssignmentDef smallThreshold() {
    return {.threshold = 0.001, .thresholdShare = 0.0};
}

// 300 characters on a lattice, each at the place that it holds.
struct StandingCrowd {
    muster_test::WallCosts& costs;
    muster::ThreadPool pool{1};
    muster::DynamicAssignmentDef def = smallThreshold();
    muster::AssignmentInput input;
    muster::ExchangeGraph graph;
    muster::InitialAssignment initial;
    muster::ColumnGeneration generation;

    explicit StandingCrowd(muster_test::WallCosts& made) : costs(made) {
        for (std::int32_t k = 0; k < 300; ++k)
            costs.characters.push_back({static_cast<double>(k % 20), static_cast<double>(k / 20)});
        costs.places = costs.characters;
        input = {costs.characters, costs.places, {}, {}};
        graph.reset(300, 300);
        graph.assignPlaces(muster_test::ascending(300));
        generation.reset(300);
    }
    muster::AssignmentStep begin() { return graph.beginStep({def, input, costs, pool}, initial); }
};

}  // namespace

TEST_CASE("column generation finds exchanges between places that are no neighbours") {
    muster::ThreadPool pool(1);
    TunnelScene scene;
    DynamicAssignment assignment;
    assignment.warmStart(smallThreshold(), scene.input(), scene.placeOf, scene.costs, pool);
    const double before = assignment.objective();
    const double optimum = scene.optimum();
    REQUIRE(optimum < before - 20.0);
    // 400 nodes, of each a seventh of all pairs at a time: all pairs are evaluated after 2,800 steps.
    for (int k = 0; k < 4000; ++k) assignment.update(smallThreshold(), scene.input(), scene.costs, pool);
    CHECK(assignment.objective() < optimum + 0.05);
    CHECK(assignment.objective() > optimum - 1e-3);
    std::int32_t used = 0;
    for (const muster::AssignmentPair& t : scene.costs.tunnels)
        used += assignment.placeOf()[t.character] == t.place ? 1 : 0;
    // No arc to a neighbour leads there.
    CHECK(used > 0);
}

TEST_CASE("an expensive place finds the character it is cheap for before that character itself is priced") {
    TunnelCosts costs;
    StandingCrowd crowd(costs);
    costs.places[0] = {-25.0, 0.0};
    costs.tunnels = {{150, 0}};
    const muster::AssignmentStep step = crowd.begin();
    muster::ExchangeGraph& graph = crowd.graph;
    graph.duals()[0] = 600.0;  // So that the place pays for nobody else.
    graph.rebuildArcs(step);
    REQUIRE(graph.expensiveNodes() == std::vector<std::int32_t>{0});
    // A step evaluates a fifth of all characters; node 150 itself is priced after seventy steps.
    for (int k = 0; k < 6; ++k) crowd.generation.run(step, graph, 1e-6);
    const std::int32_t arc = muster::ExchangeArcs::generatedArc(150);
    CHECK(graph.arcs().head(arc) == 0);
    CHECK(graph.arcs().cost(arc) == doctest::Approx(graph.arcCost(step, 150, 0, 0.04)));
}

TEST_CASE("no cost is evaluated where the straight line shows that the arc cannot be violated") {
    // Everybody stands on its place.
    class CountingCosts final : public muster_test::WallCosts {
    public:
        mutable long evaluations = 0;
        double exact(std::size_t i, std::size_t j) const override {
            ++evaluations;
            return WallCosts::exact(i, j);
        }
    };
    CountingCosts costs;
    StandingCrowd crowd(costs);
    const muster::AssignmentStep step = crowd.begin();
    crowd.graph.rebuildArcs(step);
    costs.evaluations = 0;
    for (int k = 0; k < 400; ++k) crowd.generation.run(step, crowd.graph, 1e-6);
    CHECK(costs.evaluations == 0);
    CHECK(crowd.generation.generated() == 0);
}
