#include "engine/assignment/planning/plan.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/assignment/planning/plan_scene.h"

namespace {

using muster::Plan;
using muster::PlanDef;
using muster::PlanResult;
using muster::StatusCode;
using muster::Vec2;
using muster_test::exactPlan;
using muster_test::OwnedInput;
using muster_test::placesOf;
using muster_test::planAtOnce;
using Places = std::vector<std::int32_t>;

PlanDef definition(double exponent, double threshold) {
    return {.exponent = exponent, .commitThreshold = threshold, .commitThresholdShare = 0.0};
}

OwnedInput onLine(const std::vector<double>& characters, const std::vector<double>& places,
                  const Places& incumbent) {
    OwnedInput input{.cost = muster_test::uniformGround({{-8, -2}, {8, 2}}, 0.25)};
    for (const double x : characters) input.characters.push_back({x, 0.0});
    for (const double x : places) input.places.push_back({x, 0.0});
    input.incumbent = incumbent;
    return input;
}

// The least sum of powers of straight distances over all permutations.
double bestByHand(const OwnedInput& input, double exponent) {
    std::vector<std::size_t> order(input.places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double best = muster_test::kUnreachable;
    do {
        double sum = 0.0;
        for (std::size_t i = 0; i < order.size(); ++i)
            sum += std::pow(distance(input.characters[i], input.places[order[i]]), exponent);
        best = std::min(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

}  // namespace

TEST_CASE("on open ground the plan is the best of all permutations of straight lines") {
    muster::Random random(2);
    const auto ground = muster_test::uniformGround({{-8, -8}, {8, 8}}, 0.25);
    for (const double exponent : {1.0, 2.0}) {
        for (int k = 0; k < 5; ++k) {
            const OwnedInput input = muster_test::randomInput(random, ground, 6, {{-7, -7}, {-1, 7}},
                                                              {{1, -7}, {7, 7}});
            PlanResult result = exactPlan(definition(exponent, 0.1), input);
            CHECK(result.flows.size() == 6);
            CHECK(result.reassigned == 6);
            CHECK(result.gapBound == 0.0);
            // Fields are a discretisation: within 1 %.
            CHECK(result.objective == doctest::Approx(bestByHand(input, exponent)).epsilon(0.01 * exponent));
            double sum = 0.0;
            for (const double c : result.cost) sum += std::pow(c, exponent);
            CHECK(sum == doctest::Approx(result.objective).epsilon(1e-12));
        }
    }
}

TEST_CASE("a late arrival makes others shift inward when the exponent is above 1") {
    // Places are numbered from the inside outward. The inner one is free; the late character comes from
    // outside (SPEC A7).
    const OwnedInput input = onLine({1, 2, 3, 6}, {0, 1, 2, 3}, {1, 2, 3, -1});
    PlanResult result = exactPlan(definition(2.0, 0.1), input);
    CHECK(placesOf(result, 4) == Places{0, 1, 2, 3});
    CHECK(result.objective == doctest::Approx(1 + 1 + 1 + 9).epsilon(0.02));
    CHECK(result.reassigned == 4);
}

TEST_CASE("a shift inward is not committed for less than the threshold") {
    // The late character already walks to the inner place: 36 against 12.
    const OwnedInput input = onLine({1, 2, 3, 6}, {0, 1, 2, 3}, {1, 2, 3, 0});
    PlanResult result = exactPlan(definition(2.0, 30.0), input);
    CHECK(placesOf(result, 4) == Places{1, 2, 3, 0});
    CHECK(result.reassigned == 0);
    CHECK(result.gapBound == doctest::Approx(24.0).epsilon(0.02));
    result = exactPlan(definition(2.0, 20.0), input);
    CHECK(placesOf(result, 4) == Places{0, 1, 2, 3});
    CHECK(result.gapBound == 0.0);
}

TEST_CASE("a wall makes a near place costly") {
    OwnedInput input{.cost = muster_test::uniformGround({{-8, -8}, {8, 8}}, 0.25)};
    muster_test::addWall(input.cost, {{-0.3, -6}, {0.3, 8}});
    // Character 0 stands across the wall from place 0, character 1 near the end of the wall.
    input.characters = {{-1.5, 5}, {-1.5, -5}};
    input.places = {{1.5, 5}, {-1.5, 1}};
    input.noIncumbents();
    PlanDef def = definition(1.0, 0.0);
    PlanResult result = exactPlan(def, input);
    CHECK(placesOf(result, 2) == Places{1, 0});
    // Around both lower corners of the wall, which blocked cells put at (-+0.25, -6).
    const Vec2 left{-0.25, -6}, right{0.25, -6};
    const double expected = distance({-1.5, -5}, left) + distance(left, right) + distance(right, {1.5, 5});
    CHECK(result.cost[1] == doctest::Approx(expected).epsilon(0.03));
    def.geodesic = false;
    result = exactPlan(def, input);
    CHECK(placesOf(result, 2) == Places{0, 1});
    CHECK(result.cost[0] == 3.0);
    CHECK(result.cost[1] == 6.0);
}

TEST_CASE("more characters than places, more places than characters") {
    PlanResult result = exactPlan(definition(2.0, 0.1), onLine({5, 1, 3}, {0, 2.5}, {-1, -1, -1}));
    CHECK(placesOf(result, 3) == Places{-1, 0, 1});
    CHECK(result.cost[0] == muster_test::kUnreachable);
    result = exactPlan(definition(2.0, 0.1), onLine({1}, {0, 2.5, 1.25}, {-1}));
    CHECK(placesOf(result, 1) == Places{2});
    for (const auto& input : {onLine({}, {}, {}), onLine({}, {1}, {}), onLine({1}, {}, {-1})}) {
        result = exactPlan(definition(2.0, 0.1), input);
        CHECK(result.flows.empty());
        CHECK(result.objective == 0.0);
    }
}

TEST_CASE("unusable and unreachable places are given up") {
    OwnedInput input = onLine({1, 2}, {1, 2, 5}, {0, 1});
    input.usable = {0, 1, 1};
    PlanResult result = exactPlan(definition(2.0, 1e6), input);
    // Squared, two short steps beat a long one; the exchange matches one more, so that no threshold applies.
    CHECK(placesOf(result, 2) == Places{1, 2});
    CHECK(result.gapBound == 0.0);

    OwnedInput split = onLine({1, 2}, {-5, 2, 5}, {0, 1});
    muster_test::addWall(split.cost, {{-1.5, -2}, {-0.5, 2}});
    result = exactPlan(definition(2.0, 1e6), split);
    CHECK(placesOf(result, 2) == Places{1, 2});
    split.places.pop_back();
    result = exactPlan(definition(2.0, 1e6), split);
    CHECK(placesOf(result, 2) == Places{-1, 1});
}

TEST_CASE("without reassignment places stay, however costly") {
    OwnedInput input = onLine({1, 2, 4}, {2, 1}, {0, 1, -1});
    PlanDef def = definition(2.0, 0.0);
    def.reassign = false;
    PlanResult result = exactPlan(def, input);
    CHECK(placesOf(result, 3) == Places{0, 1, -1});
    CHECK(result.reassigned == 0);
    CHECK(result.objective == doctest::Approx(2.0).epsilon(0.02));
}

TEST_CASE("supplies other than one are split over places") {
    OwnedInput input = onLine({0, 4}, {0, 1, 4}, {-1, -1});
    input.supply = {2.0, 0.5};
    input.demand = {1.5, 1.0, 0.25};
    PlanResult result = exactPlan(definition(1.0, 0.0), input);
    REQUIRE(result.flows.size() == 4);
    CHECK(result.flows[0].amount == 1.5);
    CHECK(result.flows[1].amount == 0.5);
    CHECK(result.flows[2].place == 1);
    CHECK(result.flows[2].amount == 0.25);
    CHECK(result.flows[3].amount == 0.25);
    CHECK(placesOf(result, 2) == Places{0, 1});
}

TEST_CASE("limited fronts give the same optimum as unlimited ones") {
    const int changes = muster_test::changesByLimitedFronts(
        77, 40, [](int k) { return definition(k % 2 ? 2.0 : 1.0, 0.0); },
        [](const PlanResult& narrow, const PlanResult& wide) {
            CHECK(narrow.flows.size() == wide.flows.size());
            CHECK(narrow.objective == doctest::Approx(wide.objective).epsilon(1e-9));
            CHECK(narrow.gapBound <= 1e-9 * wide.objective);
        });
    CHECK(changes > 50);
}

TEST_CASE("slices and threads change nothing") {
    muster::Random random(8);
    auto ground = muster_test::uniformGround({{-8, -8}, {8, 8}}, 0.25);
    muster_test::addWall(ground, {{-1, -6}, {1, 6}});
    const OwnedInput input = muster_test::randomInput(random, ground, 12, {{-7, -7}, {-2, 7}},
                                                      {{2, -7}, {7, 7}});
    PlanResult expected = exactPlan(definition(2.0, 0.1), input);
    for (const std::int32_t slices : {1, 3, 4, 40}) {
        muster::ThreadPool pool(1 + slices % 4);
        const auto plan = muster::makeExactPlan();
        REQUIRE(plan->start(definition(2.0, 0.1), input.view()).ok());
        CHECK(plan->pending());
        for (std::int32_t slice = 0; slice < slices - 1; ++slice) plan->advance(slice, slices, pool);
        PlanResult result;
        REQUIRE(plan->finish(pool, result).ok());
        CHECK(!plan->pending());
        CHECK(result.objective == expected.objective);
        CHECK(result.cost == expected.cost);
        CHECK(placesOf(result, 12) == placesOf(expected, 12));
    }
}

TEST_CASE("inputs are frozen by start") {
    OwnedInput input = onLine({1, 2}, {2, 1}, {-1, -1});
    const auto plan = muster::makeExactPlan();
    REQUIRE(plan->start(definition(2.0, 0.0), input.view()).ok());
    input.characters = {{2, 0}, {1, 0}};
    input.cost.cells.clear();
    PlanResult result;
    muster::ThreadPool pool(1);
    REQUIRE(plan->finish(pool, result).ok());
    CHECK(placesOf(result, 2) == Places{1, 0});
    // The front stops soon after it has reached both characters.
    CHECK(plan->costAt(0, {-6, 0}) == muster_test::kUnreachable);
    CHECK(plan->costAt(0, {1.5, 0}) == doctest::Approx(0.5).epsilon(0.02));
    CHECK(plan->costAt(7, {1.5, 0}) == muster_test::kUnreachable);
}

TEST_CASE("bad input is refused by name and changes nothing") {
    const auto plan = muster::makeExactPlan();
    const OwnedInput good = onLine({1, 2}, {2, 1}, {-1, -1});
    const PlanDef def = definition(2.0, 0.0);
    const auto refused = [&](const PlanDef& badDef, const OwnedInput& bad) {
        const muster::Status status = plan->start(badDef, bad.view());
        CHECK(status.code() == StatusCode::InvalidArgument);
        CHECK(!plan->pending());
        return status.message();
    };
    OwnedInput bad = good;
    bad.incumbent = {0, 2};
    CHECK(refused(def, bad) == "plan incumbent 1 is place 2 of 2");
    bad = good;
    bad.incumbent.pop_back();
    CHECK(refused(def, bad) == "plan incumbent has 1 values, expected 2");
    bad = good;
    bad.characters[1].x = std::nan("");
    CHECK(refused(def, bad) == "plan character 1 is not at a finite position");
    bad = good;
    bad.demand = {1.0, -2.0};
    CHECK(refused(def, bad) == "plan demand 1 is not a finite number >= 0");
    bad = good;
    bad.cost.cells.pop_back();
    CHECK(refused(def, bad) == "plan unit cost does not fill its grid");
    CHECK(refused(definition(0.5, 0.0), good) == "plan exponent is not in [1, 16]");
    CHECK(refused(definition(2.0, -1.0), good) == "plan threshold is not a finite number >= 0");
    muster::PlanInput none = good.view();
    none.costs = nullptr;
    CHECK(plan->start(def, none).message() == "plan has no costs");
    PlanResult result;
    muster::ThreadPool pool(1);
    CHECK(plan->finish(pool, result).message() == "no plan is under way");
}

TEST_CASE("a place whose incumbent is cut off goes to another character at once") {
    // The incumbent is near but behind a wall, the other character far away.
    OwnedInput input = onLine({-2.5, 14}, {1}, {0, -1});
    input.cost = muster_test::uniformGround({{-16, -2}, {16, 2}}, 0.25);
    muster_test::addWall(input.cost, {{-1.5, -2}, {-0.5, 2}});
    PlanResult result = exactPlan(definition(2.0, 0.1), input);
    CHECK(placesOf(result, 2) == Places{-1, 0});
}

TEST_CASE("without reassignment unusable places are given up") {
    OwnedInput input = onLine({1, 2}, {1, 2}, {0, 1});
    input.usable = {0, 1};
    PlanDef def = definition(2.0, 0.0);
    def.reassign = false;
    PlanResult result = exactPlan(def, input);
    CHECK(placesOf(result, 2) == Places{-1, 1});
}

TEST_CASE("the unmatched wait at the nearest place in their region, and its field reaches them") {
    OwnedInput input = onLine({1, 2, 12, -6}, {1, 2, 4}, {0, 1, -1, -1});
    input.usable = {1, 1, 0};
    input.cost = muster_test::uniformGround({{-16, -2}, {16, 2}}, 0.25);
    muster_test::addWall(input.cost, {{-3.5, -2}, {-2.5, 2}});
    const auto plan = muster::makeExactPlan();
    PlanResult result;
    REQUIRE(planAtOnce(*plan, definition(2.0, 0.1), input, result).ok());
    CHECK(placesOf(result, 4) == Places{0, 1, -1, -1});
    CHECK(plan->waitingPlace(0) == -1);
    CHECK(plan->waitingPlace(2) == 1);
    CHECK(plan->waitingPlace(3) == -1);  // Behind the wall there is none.
    CHECK(plan->costAt(1, {12, 0}) == doctest::Approx(10.0).epsilon(0.02));
}
