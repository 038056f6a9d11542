// The exact plan with the bottleneck objective.
#include <doctest.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/assignment/planning/plan_scene.h"

namespace {

using muster::PlanDef;
using muster::PlanResult;
using muster::Vec2;
using muster_test::exactPlan;
using muster_test::OwnedInput;
using muster_test::placesOf;
using Places = std::vector<std::int32_t>;

PlanDef bottleneckDef(double threshold, bool geodesic) {
    return {
        .commitThreshold = threshold, .commitThresholdShare = 0.0, .bottleneck = true, .geodesic = geodesic};
}

// Cost of the costliest matched pair.
double bottleneckOf(const PlanResult& result) {
    double costliest = 0.0;
    for (const double c : result.cost)
        if (c < muster_test::kUnreachable) costliest = std::max(costliest, c);
    return costliest;
}

// Bottleneck and sum of squares of the straight distances, lexicographically least over all permutations.
std::pair<double, double> byPermutations(const OwnedInput& input) {
    std::vector<std::size_t> order(input.places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::pair<double, double> best{muster_test::kUnreachable, muster_test::kUnreachable};
    do {
        std::pair<double, double> walk{0.0, 0.0};
        for (std::size_t i = 0; i < order.size(); ++i) {
            const double d = distance(input.characters[i], input.places[order[i]]);
            walk.first = std::max(walk.first, d);
            walk.second += d * d;
        }
        best = std::min(best, walk);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

// Character 1 stands on place 1. Least squares leaves it there and sends character 0 3 m; the bottleneck
// objective makes both walk 2.5 m.
OwnedInput triangle(const Places& incumbent) {
    return {.characters = {{-1.5, 2.0}, {0.0, 0.0}},
            .places = {{1.5, 2.0}, {0.0, 0.0}},
            .incumbent = incumbent,
            .cost = muster_test::uniformGround({{-4, -4}, {4, 4}}, 0.25)};
}

}  // namespace

TEST_CASE("the bottleneck is the least of all permutations, and the sum of squares the least among these") {
    muster::Random random(21);
    const auto ground = muster_test::uniformGround({{-8, -8}, {8, 8}}, 0.5);
    int differs = 0;
    for (int k = 0; k < 25; ++k) {
        const OwnedInput input = muster_test::randomInput(random, ground, 6, {{-7, -7}, {7, 7}},
                                                          {{-7, -7}, {7, 7}});
        PlanResult result, squares;
        result = exactPlan(bottleneckDef(0.0, false), input);
        const auto [walk, sum] = byPermutations(input);
        CHECK(bottleneckOf(result) == doctest::Approx(walk).epsilon(1e-12));
        CHECK(result.objective == doctest::Approx(sum).epsilon(1e-9));
        CHECK(result.gapBound <= 1e-9 * sum);
        PlanDef def = bottleneckDef(0.0, false);
        def.bottleneck = false;
        squares = exactPlan(def, input);
        CHECK(squares.objective <= result.objective * (1.0 + 1e-12));
        CHECK(bottleneckOf(squares) >= bottleneckOf(result) * (1.0 - 1e-12));
        differs += bottleneckOf(squares) > 1.01 * bottleneckOf(result) ? 1 : 0;
    }
    CHECK(differs > 0);  // Otherwise the two objectives were never distinguished.
}

TEST_CASE("two characters share the distance where one alone would walk farther") {
    for (const bool geodesic : {false, true}) {
        PlanResult result = exactPlan(bottleneckDef(0.1, geodesic), triangle({-1, -1}));
        CHECK(placesOf(result, 2) == Places{1, 0});
        PlanDef def = bottleneckDef(0.1, geodesic);
        def.bottleneck = false;
        result = exactPlan(def, triangle({-1, -1}));
        CHECK(placesOf(result, 2) == Places{0, 1});
    }
}

TEST_CASE("the bottleneck is lowered only by more than the commit threshold") {
    PlanResult result;
    // The bottleneck falls from 9 to 6.25, whatever becomes of the sum.
    result = exactPlan(bottleneckDef(2.7, false), triangle({0, 1}));
    CHECK(placesOf(result, 2) == Places{1, 0});
    CHECK(result.objective == doctest::Approx(12.5).epsilon(1e-12));
    result = exactPlan(bottleneckDef(2.8, false), triangle({0, 1}));
    CHECK(placesOf(result, 2) == Places{0, 1});
    CHECK(result.reassigned == 0);
    // No exchange raises the bottleneck for the sake of the sum.
    result = exactPlan(bottleneckDef(0.0, false), triangle({1, 0}));
    CHECK(result.reassigned == 0);
}

TEST_CASE("as many characters as possible are matched first, however far one has to walk") {
    OwnedInput input{.characters = {{-7, 0}, {0, 0}, {1, 0}},
                     .places = {{0.5, 0}, {7, 0}, {1.5, 0}},
                     .cost = muster_test::uniformGround({{-8, -2}, {8, 2}}, 0.25)};
    input.noIncumbents();
    PlanResult result = exactPlan(bottleneckDef(0.1, true), input);
    CHECK(placesOf(result, 3) == Places{0, 2, 1});
    input.usable = {1, 0, 1};
    result = exactPlan(bottleneckDef(0.1, true), input);
    CHECK(placesOf(result, 3) == Places{-1, 0, 2});
}

TEST_CASE("limited fronts give the same bottleneck") {
    const int changes = muster_test::changesByLimitedFronts(
        78, 30, [](int) { return bottleneckDef(0.0, true); },
        [](const PlanResult& narrow, const PlanResult& wide) {
            CHECK(bottleneckOf(narrow) == doctest::Approx(bottleneckOf(wide)).epsilon(1e-9));
            CHECK(narrow.objective == doctest::Approx(wide.objective).epsilon(1e-9));
        });
    CHECK(changes > 30);
}
