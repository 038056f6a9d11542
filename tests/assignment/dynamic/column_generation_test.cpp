// Exchanges that the sparse graph has no arc for: far away in metres, near by the cost.
#include <doctest.h>

#include "assignment/dynamic/assignment_scene.h"

namespace {

using muster::DynamicAssignment;
using muster::Vec2;

// Straight distances, but for pairs joined by a tunnel.
class TunnelCosts final : public muster_test::ClosedCosts {
public:
    std::vector<muster::AssignmentPair> tunnels;
    double length = 0.2;

    double exact(std::size_t i, std::size_t j) const override {
        for (const muster::AssignmentPair& t : tunnels)
            if (t.character == static_cast<std::int32_t>(i) && t.place == static_cast<std::int32_t>(j))
                return length;
        return ClosedCosts::exact(i, j);
    }
    double leastUnitCost() const override { return 0.0; }
};

// A block of 400 who stand a metre beside their places; a dozen know tunnels to places at the other end.
struct TunnelScene {
    TunnelCosts costs;
    std::vector<std::int32_t> own;

    TunnelScene() {
        for (std::int32_t k = 0; k < 400; ++k) {
            costs.places.push_back({static_cast<double>(k % 20), static_cast<double>(k / 20)});
            costs.characters.push_back(costs.places.back() + Vec2{1.0, 0.01 * (k % 7)});
            own.push_back(k);
        }
        // Both ways, so that an exchange of two gains: 2 - 0.08 square metres each.
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

muster::DynamicAssignmentDef sharpDef() {
    muster::DynamicAssignmentDef def;
    def.threshold = 0.001;
    def.thresholdShare = 0.0;
    return def;
}

// 300 people on a lattice, each on the place it holds; no arcs.
struct Standing {
    muster_test::ClosedCosts& costs;
    muster::ThreadPool pool{1};
    muster::DynamicAssignmentDef def = sharpDef();
    muster::AssignmentInput input;
    muster::ExchangeGraph state;
    muster::ColumnGeneration pricing;

    explicit Standing(muster_test::ClosedCosts& made) : costs(made) {
        std::vector<std::int32_t> own;
        for (std::int32_t k = 0; k < 300; ++k) {
            costs.characters.push_back({static_cast<double>(k % 20), static_cast<double>(k / 20)});
            own.push_back(k);
        }
        costs.places = costs.characters;
        input = {costs.characters, costs.places, {}, {}};
        state.reset(300, 300);
        state.seats.warmStart(own);
        std::vector<std::int32_t> flipped;
        state.seats.follow(input, flipped);
        pricing.reset(300);
    }
    muster::AssignmentStep context() {
        return {def, input, costs, pool, muster::CostPower(2.0), {}, {}, def.threshold};
    }
};

}  // namespace

TEST_CASE("exchanges between places that are no neighbours are found by pricing") {
    muster::ThreadPool pool(1);
    TunnelScene scene;
    DynamicAssignment matching;
    matching.warmStart(sharpDef(), scene.input(), scene.own, scene.costs, pool);
    const double before = matching.objective();
    const double optimum = scene.optimum();
    REQUIRE(optimum < before - 20.0);
    // 400 seats, of each a seventh of all pairs at a time: 2,800 steps until all had their turn.
    for (int k = 0; k < 4000; ++k) matching.update(sharpDef(), scene.input(), scene.costs, pool);
    CHECK(matching.objective() < optimum + 0.05);
    CHECK(matching.objective() > optimum - 1e-3);
    std::int32_t used = 0;
    for (const muster::AssignmentPair& t : scene.costs.tunnels)
        used += matching.placeOf()[t.character] == t.place ? 1 : 0;
    // No arc to a neighbour leads there.
    CHECK(used > 0);
}

TEST_CASE(
    "who had best take a dear place is found from the place, whose turn comes before that of all others") {
    TunnelCosts costs;
    Standing standing(costs);
    costs.places[0] = {-25.0, 0.0};
    costs.tunnels = {{150, 0}};
    const muster::AssignmentStep context = standing.context();
    muster::ExchangeGraph& state = standing.state;
    state.setOwn(0, 25.0f, context.power);
    state.price[0] = 600.0;  // Nobody else had best go there.
    state.arcs.look(context, state.seats, state.price, state.own);
    REQUIRE(state.arcs.hot() == std::vector<std::int32_t>{0});
    // A fifth of all characters at a time; the row of the one that knows a tunnel would wait for seventy
    // steps.
    for (int k = 0; k < 6; ++k) standing.pricing.run(context, state, 1e-6);
    CHECK(state.arcs.target(state.arcs.priced(150)) == 0);
    CHECK(state.arcs.weight(state.arcs.priced(150)) == doctest::Approx(0.04));
}

TEST_CASE("pricing asks for no cost where the straight line says that it cannot pay") {
    // Everybody stands on its place: no pair is worth a question, whatever the number of turns.
    class Counting final : public muster_test::ClosedCosts {
    public:
        mutable long asked = 0;
        double exact(std::size_t i, std::size_t j) const override {
            ++asked;
            return ClosedCosts::exact(i, j);
        }
    };
    Counting costs;
    Standing standing(costs);
    const muster::AssignmentStep context = standing.context();
    standing.state.arcs.look(context, standing.state.seats, standing.state.price, standing.state.own);
    for (int k = 0; k < 400; ++k) standing.pricing.run(context, standing.state, 1e-6);
    CHECK(costs.asked == 0);
    CHECK(standing.pricing.found() == 0);
}
