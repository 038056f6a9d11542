// Judges against brute force, analysis and each other.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/random.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "scale/judge.h"

using namespace muster;
using namespace muster::scale;

namespace {

/// Ground of 40 m with or without a wall of 12 m in the middle.
UnitCost ground(bool wall) {
    EnvironmentDef def{.box = {{-20, -20}, {20, 20}}};
    Environment environment = Environment::create(def).value();
    if (wall) CHECK(environment.addObstacle({.polygon = {{-0.5, -6}, {0.5, -6}, {0.5, 6}, {-0.5, 6}}}).ok());
    environment.setTime(0.0);
    UnitCost cost;
    UnitCostBuilder().build({}, environment, DensityField(def.box, {}), 0.25, cost);
    return cost;
}

/// Places in rows 1 m apart; characters `away` of them, each off by up to `jitter`, and their own places.
Committed following(std::int32_t n, Vec2 first, Vec2 away, double jitter, std::uint64_t seed) {
    Random random(seed);
    Committed plan;
    const auto across = static_cast<std::int32_t>(std::ceil(std::sqrt(n)));
    for (std::int32_t k = 0; k < n; ++k) {
        const Vec2 place = first + Vec2{1.0 * (k % across), 1.0 * (k / across)};
        plan.places.push_back(place);
        plan.characters.push_back(place - away +
                                  Vec2{random.uniform(-jitter, jitter), random.uniform(-jitter, jitter)});
        plan.placeOf.push_back(k);
    }
    return plan;
}

/// Costs of all pairs, each place's field marched over the whole ground.
std::vector<double> allCosts(const UnitCost& cost, const Committed& plan) {
    const std::size_t n = plan.places.size();
    std::vector<double> all(n * n);
    EikonalSolver solver;
    CostField field;
    for (std::size_t j = 0; j < n; ++j) {
        solver.solve(cost, plan.places[j], {}, field);
        for (std::size_t i = 0; i < n; ++i)
            all[i * n + j] = std::pow(field.cost(plan.characters[i]), plan.exponent);
    }
    return all;
}

double sumOf(const std::vector<double>& all, const std::vector<std::int32_t>& placeOf) {
    double sum = 0.0;
    for (std::size_t i = 0; i < placeOf.size(); ++i)
        sum += all[i * placeOf.size() + static_cast<std::size_t>(placeOf[i])];
    return sum;
}

double cheapest(const std::vector<double>& all, std::size_t n) {
    std::vector<std::int32_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    double least = std::numeric_limits<double>::infinity();
    do least = std::min(least, sumOf(all, order));
    while (std::next_permutation(order.begin(), order.end()));
    return least;
}

}  // namespace

TEST_CASE("two exchanged characters have the gap of analysis, for both judges") {
    const UnitCost cost = ground(false);
    ThreadPool pool(2);
    Committed plan = following(25, {0, 0}, {2, 0}, 0.0, 1);
    std::swap(plan.placeOf[6], plan.placeOf[7]);
    // (2 + 1)^2 + (2 - 1)^2 instead of 2 * 2^2: 2 more than 25 * 4.
    const Verdict exact = judgeExactly(cost, plan, pool).value();
    CHECK(exact.bound == doctest::Approx(100.0).epsilon(1e-4));
    CHECK(exact.gap(2.0) == doctest::Approx(0.02).epsilon(1e-3));
    const Verdict bound = judgeByBound(cost, plan, pool);
    CHECK(bound.bound == doctest::Approx(100.0).epsilon(1e-4));
    CHECK(bound.gap(2.0) == doctest::Approx(0.02).epsilon(1e-3));
}

TEST_CASE("a gap at an optimum near zero is relative to a quarter of a metre per character") {
    const UnitCost cost = ground(false);
    ThreadPool pool(1);
    Committed plan = following(9, {0, 0}, {0, 0}, 0.0, 1);
    std::swap(plan.placeOf[0], plan.placeOf[1]);
    const double expected = 2.0 / (9.0 * 0.0625);
    CHECK(judgeExactly(cost, plan, pool)->gap(2.0) == doctest::Approx(expected).epsilon(1e-3));
    CHECK(judgeByBound(cost, plan, pool).gap(2.0) == doctest::Approx(expected).epsilon(1e-3));
}

TEST_CASE("both judges find what brute force finds, with six on both sides of a wall") {
    const UnitCost cost = ground(true);
    ThreadPool pool(2);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Random random(seed);
        Committed plan{.exponent = seed % 2 == 0 ? 1.0 : 2.0};
        for (std::int32_t k = 0; k < 6; ++k) {
            plan.characters.push_back({random.uniform(-6, -2), random.uniform(-5, 5)});
            plan.places.push_back(
                {random.uniform(k % 3 == 0 ? -6 : 2, k % 3 == 0 ? -2 : 6), random.uniform(-5, 5)});
            plan.placeOf.push_back((k + 2) % 6);
        }
        const std::vector<double> all = allCosts(cost, plan);
        const double least = cheapest(all, 6);
        const double committed = sumOf(all, plan.placeOf);
        for (const Verdict& verdict :
             {judgeExactly(cost, plan, pool).value(), judgeByBound(cost, plan, pool, 20)}) {
            CHECK(verdict.bound == doctest::Approx(least).epsilon(2e-3));
            CHECK(verdict.committed == doctest::Approx(committed).epsilon(2e-3));
            CHECK(verdict.matched == 6);
        }
    }
}

TEST_CASE("the judges agree on sixty, and the bound is never above the optimum") {
    ThreadPool pool(2);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const UnitCost cost = ground(seed % 2 == 0);
        Committed plan = following(60, {-5, -4}, {seed % 3 == 0 ? 9.0 : 2.0, 0.5}, 0.4, seed);
        Random random(seed);
        for (int swaps = 0; swaps < 5; ++swaps)
            std::swap(plan.placeOf[random.below(60)], plan.placeOf[random.below(60)]);
        const Verdict exact = judgeExactly(cost, plan, pool).value();
        const Verdict bound = judgeByBound(cost, plan, pool);
        CHECK(bound.gap(2.0) > 0.0);
        CHECK(std::fabs(exact.gap(2.0) - bound.gap(2.0)) < 5e-4);
        CHECK(bound.bound <= exact.bound * (1.0 + 1e-4));
    }
}

TEST_CASE("characters without a place or with one out of reach do not change the result") {
    UnitCost cost = ground(false);
    ThreadPool pool(1);
    Committed plan = following(16, {0, 0}, {1.5, 0}, 0.2, 3);
    const Verdict whole = judgeByBound(cost, plan, pool);
    plan.placeOf[15] = -1;
    plan.placeOf[3] = -1;
    const Verdict exact = judgeExactly(cost, plan, pool).value();
    const Verdict bound = judgeByBound(cost, plan, pool);
    CHECK(exact.matched == 14);
    CHECK(bound.matched == 14);
    CHECK(bound.committed < whole.committed);
    CHECK(bound.bound == doctest::Approx(exact.bound).epsilon(1e-3));
    // Nothing to do at all.
    const Verdict nothing = judgeByBound(cost, Committed{}, pool);
    CHECK(nothing.matched == 0);
    CHECK(nothing.gap(2.0) == 0.0);
}
