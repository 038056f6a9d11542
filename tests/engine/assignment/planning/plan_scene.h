// Small grounds and inputs for tests of plans.
#pragma once

#include <doctest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "base/as_mutable.h"
#include "base/random.h"
#include "engine/assignment/planning/fixed_costs.h"
#include "engine/assignment/planning/plan.h"

namespace muster_test {

inline constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// Uniform ground: unit cost 1, no walls.
inline muster::UnitCost uniformGround(muster::Box box, double cell) {
    muster::UnitCost cost{.grid = muster::Grid::covering(box, cell)};
    cost.cells.assign(cost.grid.count(), {});
    cost.lowest = 1.0f;
    return cost;
}

/// Makes walls of the cells whose centres lie in `box`, and closes the sides of their neighbours.
inline void addWall(muster::UnitCost& cost, muster::Box box) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    for (std::int32_t k = 0; k < cost.grid.count(); ++k) {
        const muster::Cell c = cost.grid.at(k);
        if (!box.contains(cost.grid.centre(c))) continue;
        cost.cells[k] = {kInfinite, kInfinite, kInfinite, kInfinite};
        if (c.x > 0) cost.cells[k - 1].east = kInfinite;
        if (c.x + 1 < cost.grid.width) cost.cells[k + 1].west = kInfinite;
        if (c.y > 0) cost.cells[k - cost.grid.width].north = kInfinite;
        if (c.y + 1 < cost.grid.height) cost.cells[k + cost.grid.width].south = kInfinite;
    }
}

/// Plan inputs that own their data.
struct OwnedInput {
    std::vector<muster::Vec2> characters;
    std::vector<double> supply;
    std::vector<muster::Vec2> places;
    std::vector<double> demand;
    std::vector<std::uint8_t> usable;
    std::vector<std::int32_t> incumbent;
    muster::UnitCost cost;

    muster::FixedCosts costs = {};

    /// Valid until the input moves.
    muster::PlanInput view() const {
        auto& given = muster::asMutable(costs);
        given.unit = &cost;
        return {characters, supply, places, demand, usable, incumbent, &given};
    }
    /// Makes everybody unmatched.
    void noIncumbents() { incumbent.assign(characters.size(), -1); }
};

/// `count` characters at random in `from`, as many places in `to`.
inline OwnedInput randomInput(muster::Random& random, const muster::UnitCost& cost, std::int32_t count,
                              muster::Box from, muster::Box to) {
    OwnedInput input{.cost = cost};
    for (std::int32_t k = 0; k < count; ++k) {
        input.characters.push_back(
            {random.uniform(from.min.x, from.max.x), random.uniform(from.min.y, from.max.y)});
        input.places.push_back({random.uniform(to.min.x, to.max.x), random.uniform(to.min.y, to.max.y)});
    }
    input.noIncumbents();
    return input;
}

/// Place of each character by its largest flow.
inline std::vector<std::int32_t> placesOf(const muster::PlanResult& result, std::size_t characters) {
    std::vector<std::int32_t> places(characters, -1);
    std::vector<double> most(characters, 0.0);
    for (const muster::Flow& flow : result.flows) {
        if (flow.amount <= most[flow.character]) continue;
        most[flow.character] = flow.amount;
        places[flow.character] = flow.place;
    }
    return places;
}

/// The exact plan of an input.
inline muster::PlanResult exactPlan(const muster::PlanDef& def, const OwnedInput& input) {
    const auto plan = muster::makeExactPlan();
    muster::ThreadPool pool(1);
    muster::PlanResult result;
    REQUIRE(plan->start(def, input.view()).ok());
    REQUIRE(plan->finish(pool, result).ok());
    return result;
}

/// Checks that the plan of those who have moved a little since an optimum, or whose places are exchanged, is
/// the optimum, too; returns how many changed their places. Without incumbents every front is unlimited.
template <class Judge>
int changesByLimitedFronts(std::uint64_t seed, int rounds, const std::function<muster::PlanDef(int)>& defOf,
                           const Judge& same) {
    muster::Random random(seed);
    auto ground = uniformGround({{-8, -8}, {8, 8}}, 0.25);
    addWall(ground, {{-0.5, -5}, {0.5, 6}});
    int changes = 0;
    for (int k = 0; k < rounds; ++k) {
        OwnedInput input = randomInput(random, ground, 14, {{-7, -7}, {7, 7}}, {{-7, -7}, {7, 7}});
        input.incumbent = placesOf(exactPlan(defOf(k), input), 14);
        if (k % 4 == 0)
            std::rotate(input.incumbent.begin(), input.incumbent.begin() + 3, input.incumbent.end());
        for (muster::Vec2& p : input.characters) p += {random.uniform(-1, 1), random.uniform(-1, 1)};
        const muster::PlanResult narrow = exactPlan(defOf(k), input);
        changes += narrow.reassigned;
        input.noIncumbents();
        same(narrow, exactPlan(defOf(k), input));
    }
    return changes;
}

/// Starts and finishes a plan at once.
inline muster::Status planAtOnce(muster::Plan& plan, const muster::PlanDef& def, const OwnedInput& input,
                                 muster::PlanResult& result, std::int32_t threads = 1) {
    muster::ThreadPool pool(threads);
    if (muster::Status status = plan.start(def, input.view()); !status.ok()) return status;
    return plan.finish(pool, result);
}

}  // namespace muster_test
