// Costs by own speed (SPEC B10): what a way costs a character counts the time that it takes.
#include <doctest.h>

#include "engine/assignment/planning/fixed_costs.h"
#include "engine/assignment/planning/plan.h"
#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/unit_cost_builder.h"

using namespace muster;
using namespace muster::test;

namespace {

// Open ground.
struct Field {
    Environment environment = squareWorld(24.0);
    StaticGround ground;
    DynamicCost dynamicCost;
    DensityField density;
    UnitCost cost;
    FixedCosts costs;

    Field() {
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
        density = DensityField(environment.def().box, {});
        dynamicCost.update({}, environment, density, 0.25);
        UnitCostBuilder builder;
        builder.build({}, environment, density, 0.25, cost);
        costs.world = &environment;
        costs.unit = &cost;
        costs.still = &ground;
        costs.changing = &dynamicCost;
    }
    std::vector<Vec2> characters{{-6, 0}, {-6, 1}}, goals{{-2, 1}, {6, 0}};

    // Two lines of characters and two of goals.
    void fill(std::int32_t count) {
        characters.clear();
        goals.clear();
        for (std::int32_t k = 0; k < count; ++k) {
            characters.push_back({-8.0 - k % 2, 0.9 * (k / 2) - 4.0});
            goals.push_back({2.0 + 4.0 * (k % 2), 0.9 * (k / 2) - 4.0});
        }
    }
    std::vector<std::int32_t> places(Plan& plan, std::span<const float> slowness, PlanResult& result) {
        std::vector<std::int32_t> place(characters.size(), -1);
        PlanDef def{.exponent = 2.0};
        def.commitThreshold = def.commitThresholdShare = 0.0;
        ThreadPool pool;
        for (int round = 0; round < 40; ++round) {
            PlanInput input{.characters = characters,
                            .places = goals,
                            .incumbent = place,
                            .costs = &costs,
                            .slowness = slowness};
            REQUIRE(plan.start(def, input).ok());
            REQUIRE(plan.finish(pool, result).ok());
            for (const Flow& flow : result.flows) place[flow.character] = flow.place;
        }
        return place;
    }
};

}  // namespace

TEST_CASE("of two the slower one takes the nearer place") {
    Field field;
    for (const std::size_t slow : {0, 1}) {
        const auto plan = makeExactPlan();
        std::vector<float> slowness{1.0f, 1.0f};
        slowness[slow] = 3.0f;
        PlanResult result;
        const std::vector<std::int32_t> place = field.places(*plan, slowness, result);
        CHECK(place[slow] == 0);
        CHECK(place[1 - slow] == 1);
        // Three times its walk of about 4 m, and the walk of 12 m of the other one.
        const double nearWalk = slow == 1 ? 4.0 : std::sqrt(17.0);
        const double farWalk = slow == 1 ? 12.0 : std::sqrt(145.0);
        CHECK(result.cost[slow] == doctest::Approx(3.0 * nearWalk).epsilon(0.03));
        CHECK(result.cost[1 - slow] == doctest::Approx(farWalk).epsilon(0.03));
        CHECK(result.objective ==
              doctest::Approx(9.0 * nearWalk * nearWalk + farWalk * farWalk).epsilon(0.03));
    }
}

TEST_CASE("the fast plan comes near the exact one where speeds differ") {
    Field field;
    field.fill(40);
    std::vector<float> slowness(40, 1.0f);
    for (std::size_t k = 0; k < slowness.size(); k += 3) slowness[k] = 2.0f;
    PlanResult exact, fast;
    const std::vector<std::int32_t> best = field.places(*makeExactPlan(), slowness, exact);
    const std::vector<std::int32_t> found = field.places(*makeFastPlan(), slowness, fast);
    CHECK(fast.objective < 1.02 * exact.objective);
    // All 14 slow ones take places of the near line.
    for (std::size_t k = 0; k < slowness.size(); k += 3) {
        CHECK(best[k] % 2 == 0);
        CHECK(found[k] % 2 == 0);
    }
}

TEST_CASE("a factor of 1 for all changes no bit, and bad factors are refused") {
    Field field;
    for (const bool fast : {false, true}) {
        const auto plain = fast ? makeFastPlan() : makeExactPlan();
        const auto ones = fast ? makeFastPlan() : makeExactPlan();
        PlanResult a, b;
        CHECK(field.places(*plain, {}, a) == field.places(*ones, std::vector<float>{1.0f, 1.0f}, b));
        CHECK(a.objective == b.objective);
        CHECK(a.cost == b.cost);
        for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::infinity()}) {
            const std::vector<Vec2> one{{0, 0}};
            const std::vector<std::int32_t> none{-1};
            const std::vector<float> slowness{bad};
            PlanInput input;
            input.characters = input.places = one;
            input.incumbent = none;
            input.slowness = slowness;
            input.costs = &field.costs;
            CHECK(!plain->start({}, input).ok());
        }
    }
}
