#include <doctest.h>

#include <cmath>

#include "engine/assignment/planning/plan_scene.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/ground/environment/environment.h"

namespace {

using muster::Vec2;
using muster_test::OwnedInput;

// A block from (-1, -4) to (1, 4) in a world of 16 m.
muster::Environment blocked() {
    muster::Environment environment = std::move(muster::Environment::create({.box = {{-8, -8}, {8, 8}}}))
                                          .value();
    REQUIRE(environment.addObstacle({.polygon = {{-1, -4}, {1, -4}, {1, 4}, {-1, 4}}}).ok());
    environment.setTime(0.0);
    return environment;
}

muster::UnitCost groundOf(const muster::Environment& environment) {
    muster::DensityField density(environment.def().box, {});
    density.splat({}, {});
    muster::UnitCost cost;
    muster::UnitCostBuilder().build({}, environment, density, 0.25, cost);
    return cost;
}

struct Guided {
    Vec2 direction;
    double cost;
};

Guided guide(muster::Plan& plan, const muster::Environment& environment, Vec2 p, std::int32_t place,
             const std::vector<Vec2>& placesNow, double direct = 1.5) {
    Guided out{};
    muster::ThreadPool pool;
    muster::FixedCosts costs;
    costs.world = &environment;
    plan.guide({{&p, 1}, {&place, 1}, placesNow, &costs, direct}, pool, {&out.direction, 1}, {&out.cost, 1});
    return out;
}

}  // namespace

TEST_CASE("guidance: straight when near and clear, else down the field") {
    const muster::Environment environment = blocked();
    OwnedInput input{.characters = {{-3, 0.5}, {5, 5}},
                     .places = {{3, 0}, {5, 6}},
                     .incumbent = {0, 1},
                     .cost = groundOf(environment)};
    const auto plan = muster::makeExactPlan();
    muster::PlanResult result;
    // Before any plan: straight where the line is clear, else no direction.
    CHECK(guide(*plan, environment, {5, 5}, 1, input.places).direction == Vec2{0, 1});
    CHECK(guide(*plan, environment, {-3, 0}, 0, input.places).direction == Vec2{});
    REQUIRE(muster_test::planAtOnce(*plan, {}, input, result).ok());

    const Guided near = guide(*plan, environment, {5, 5}, 1, input.places);
    CHECK(near.direction == Vec2{0, 1});
    CHECK(near.cost == 1.0);
    // Around the upper corner of the block, which is the nearer, a radius away from it.
    const Guided far = guide(*plan, environment, {-3, 0.5}, 0, input.places);
    CHECK(length(far.direction) == doctest::Approx(1.0).epsilon(1e-9));
    const Vec2 corner{-1.25, 4.25};
    CHECK(dot(far.direction, normalized(corner - Vec2{-3, 0.5})) > 0.98);
    CHECK(far.cost == doctest::Approx(result.cost[0]).epsilon(1e-6));
    // Near, but behind the block: down the field.
    const Guided across = guide(*plan, environment, {-1.4, 1}, 0, {{1.4, 1}, {5, 6}}, 5.0);
    CHECK(across.direction.y > 0.7);
    // The place has moved within reach: straight to its current position.
    const Guided moved = guide(*plan, environment, {5, 5}, 1, {{3, 0}, {6, 5}});
    CHECK(moved.direction == Vec2{1, 0});
    // An unmatched character.
    const Guided none = guide(*plan, environment, {5, 5}, -1, input.places);
    CHECK(none.direction == Vec2{});
    CHECK(none.cost == muster_test::kUnreachable);
    // A place that was added after the plan was made.
    const Guided fresh = guide(*plan, environment, {5, 5}, 2, {{3, 0}, {5, 6}, {5, -5}});
    CHECK(fresh.direction == Vec2{0, -1});
}

TEST_CASE("following the guidance leads to the place around the block") {
    const muster::Environment environment = blocked();
    OwnedInput input{.cost = groundOf(environment)};
    muster::Random random(9);
    for (int k = 0; k < 8; ++k) {
        input.characters.push_back({random.uniform(-7, -2), random.uniform(-7, 7)});
        input.places.push_back({random.uniform(2, 7), random.uniform(-7, 7)});
        input.incumbent.push_back(-1);
    }
    const auto plan = muster::makeExactPlan();
    muster::PlanResult result;
    REQUIRE(muster_test::planAtOnce(*plan, {}, input, result).ok());
    const std::vector<std::int32_t> place = muster_test::placesOf(result, 8);
    for (int i = 0; i < 8; ++i) {
        Vec2 p = input.characters[i];
        double walked = 0.0;
        for (int step = 0; step < 2000 && distance(p, input.places[place[i]]) > 0.05; ++step) {
            const Guided s = guide(*plan, environment, p, place[i], input.places);
            p += s.direction * 0.03;
            walked += 0.03;
            REQUIRE(environment.distanceToObstacle(p) > 0.0);
        }
        CHECK(distance(p, input.places[place[i]]) <= 0.05);
        // The walked length is that of the field within 5 %, but for the last steps.
        CHECK(walked <= 1.05 * result.cost[i] + 0.1);
    }
}
