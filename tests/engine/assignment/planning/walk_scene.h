// A crowd that walks around a block, with a ground for both plans.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/assignment/planning/fixed_costs.h"
#include "engine/assignment/planning/plan_scene.h"
#include "engine/fields/cost/ground_scene.h"
#include "engine/fields/cost/unit_cost_builder.h"

namespace muster_test {

using namespace muster;
using namespace muster::test;

/// A crowd walks around a block to places that move. Without density the exact plan has the same costs.
struct Walk {
    Environment environment = squareWorld(24.0);
    StaticGround ground;
    DynamicCost dynamicCost;
    DensityField density;
    UnitCost cost;
    std::vector<Vec2> characters;
    std::vector<Vec2> places;
    std::vector<std::uint8_t> usable;
    std::vector<std::int32_t> incumbent;
    std::vector<std::uint8_t> characterClass, placeClass;
    std::vector<double> supply, demand;
    PlanDef def;
    mutable FixedCosts costs;  // Plans ask it for the parts above.

    Walk(std::int32_t count, Vec2 from, Vec2 to, std::uint64_t seed) {
        REQUIRE(environment.addObstacle(rectangle(-3, -6, 3, 5)).ok());
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
        density = DensityField(environment.def().box, {});
        dynamicCost.update({}, environment, density, 0.25);
        UnitCostBuilder builder;
        builder.build({}, environment, density, 0.25, cost);
        Random random(seed);
        const auto columns = static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
        for (std::int32_t k = 0; k < count; ++k) {
            const Vec2 spot = Vec2{k % columns - 0.5 * columns, k / columns - 0.5 * columns} * 0.9;
            characters.push_back(from + spot + Vec2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)});
            places.push_back(to + spot);
        }
        incumbent.assign(characters.size(), -1);
    }
    FixedCosts& given() const {
        costs.world = &environment;
        costs.unit = &cost;
        costs.still = &ground;
        costs.changing = &dynamicCost;
        return costs;
    }
    PlanInput input() const {
        return {.characters = characters,
                .supply = supply,
                .places = places,
                .demand = demand,
                .usable = usable,
                .incumbent = incumbent,
                .costs = &given(),
                .characterClass = characterClass,
                .placeClass = placeClass};
    }
    PlanResult plan(Plan& plan, ThreadPool& pool) const {
        PlanResult result;
        REQUIRE(plan.start(def, input()).ok());
        REQUIRE(plan.finish(pool, result).ok());
        return result;
    }
    void take(const PlanResult& result) { incumbent = placesOf(result, characters.size()); }
    // Moves everybody `step` metres by the plan's guidance, outside the block.
    void walk(Plan& plan, ThreadPool& pool, double step) {
        std::vector<Vec2> direction(characters.size());
        std::vector<double> left(characters.size());
        plan.guide({characters, incumbent, places, &given(), 1.5}, pool, direction, left);
        for (std::size_t i = 0; i < characters.size(); ++i)
            characters[i] = environment.projectToFreeSpace(
                characters[i] + direction[i] * std::min(step, left[i]), 0.25);
    }
    // Duality gap of the incumbents, relative to the optimum, by the exact plan.
    double gap(ThreadPool& pool) const {
        const auto judge = makeExactPlan();
        PlanDef keep = def;
        keep.commitThreshold = 1e9;
        PlanResult result;
        REQUIRE(judge->start(keep, input()).ok());
        REQUIRE(judge->finish(pool, result).ok());
        const double optimum = result.objective - result.gapBound;
        return result.gapBound / std::max(optimum, 0.0625 * static_cast<double>(characters.size()));
    }
};

}  // namespace muster_test
