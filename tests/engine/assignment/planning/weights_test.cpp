// Plans with supplies and demands.
#include <doctest.h>

#include "base/infinite_cost.h"
#include "engine/assignment/planning/main_places.h"
#include "engine/assignment/planning/walk_scene.h"

using namespace muster;
using muster_test::Walk;

namespace {

// Supplies from a quarter to three units, demands from none to three.
Walk weighted(std::int32_t count, std::uint64_t seed) {
    Walk scene(count, {-12, -1}, {11, 2}, seed);
    Random random(seed + 200);
    for (std::int32_t k = 0; k < count; ++k) {
        scene.supply.push_back(0.25 * (1 + random.below(12)));
        scene.demand.push_back(0.1 * random.below(31));
    }
    return scene;
}

// The objective, and the amount that flows, above what the exact plan finds; as shares of it.
struct Above {
    double cost = 0.0, missing = 0.0, strangers = 0.0;
};

double amountOf(const PlanResult& result) {
    double sum = 0.0;
    for (const Flow& flow : result.flows) sum += flow.amount;
    return sum;
}

double strangers(const Walk& scene, const PlanResult& result) {
    double sum = 0.0;
    for (const Flow& flow : result.flows)
        if (!scene.placeClass.empty() && scene.placeClass[flow.place] != scene.characterClass[flow.character])
            sum += flow.amount;
    return sum;
}

// Prices the flows by the fields of the exact plan, which knows no commit threshold here.
Above aboveOf(Walk& scene, const PlanResult& result, ThreadPool& pool) {
    const std::vector<std::int32_t> incumbent = scene.incumbent;
    scene.incumbent.assign(incumbent.size(), -1);
    const auto exact = makeExactPlan();
    const PlanResult best = scene.plan(*exact, pool);
    scene.incumbent = incumbent;
    double sum = 0.0;
    for (const Flow& flow : result.flows) {
        const double c = exact->costAt(flow.place, scene.characters[flow.character]);
        sum += flow.amount * c * c;
    }
    const double least = std::max(best.objective, 0.0625 * amountOf(best));
    return {sum / least - 1.0, amountOf(best) - amountOf(result),
            strangers(scene, result) - strangers(scene, best)};
}

// Nobody sends more than there is, no place gets more than it demands, every flow is listed once.
bool feasible(const Walk& scene, const PlanResult& result) {
    std::vector<double> sent(scene.supply.size(), 0.0), filled(scene.demand.size(), 0.0);
    for (std::size_t k = 0; k < result.flows.size(); ++k) {
        const Flow& flow = result.flows[k];
        if (!(flow.amount > 0.0)) return false;
        if (k > 0 && flow.character == result.flows[k - 1].character &&
            flow.place <= result.flows[k - 1].place)
            return false;
        sent[flow.character] += flow.amount;
        filled[flow.place] += flow.amount;
    }
    for (std::size_t i = 0; i < sent.size(); ++i)
        if (sent[i] > scene.supply[i] + 1e-6) return false;
    for (std::size_t j = 0; j < filled.size(); ++j)
        if (filled[j] > scene.demand[j] + 1e-6) return false;
    return true;
}

std::uint64_t hashOf(const Plan& plan) {
    Hasher hasher;
    plan.hash(hasher);
    return hasher.value();
}

}  // namespace

TEST_CASE("with weights the fast plan stays near the exact one while a crowd walks around a block") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        Walk scene = weighted(100, seed);
        if (seed == 3) {
            Random random(9);
            for (int k = 0; k < 100; ++k) {
                scene.characterClass.push_back(static_cast<std::uint8_t>(random.below(3)));
                scene.placeClass.push_back(static_cast<std::uint8_t>(random.below(3)));
            }
        }
        const auto plan = makeFastPlan();
        ThreadPool pool(2);
        double worst = 0.0;
        int turns = 0;
        for (int step = 0; step < 360; ++step) {
            const PlanResult result = scene.plan(*plan, pool);
            REQUIRE(feasible(scene, result));
            const std::vector<std::int32_t> before = scene.incumbent;
            findMainPlaces(result.flows, before, scene.incumbent);
            for (std::size_t i = 0; i < before.size() && step > 60; ++i)
                turns += before[i] != scene.incumbent[i] ? 1 : 0;
            scene.walk(*plan, pool, 0.05);
            for (Vec2& p : scene.places) p += Vec2{0.004, 0.006};
            if (step % 60 != 59) continue;
            const Above above = aboveOf(scene, scene.plan(*plan, pool), pool);
            INFO("seed " << seed << ", step " << step);
            CHECK(std::abs(above.missing) < 1e-5);
            CHECK(above.strangers < 1e-5);
            worst = std::max(worst, above.cost);
        }
        MESSAGE("seed " << seed << ": worst " << worst << ", changes of place " << turns);
        CHECK(worst < 0.02);
        CHECK(turns < 300);  // One hundred characters in five seconds.
    }
}

TEST_CASE("characters with units, and places that demand one or nothing, are an assignment") {
    Walk scene(60, {-12, -1}, {11, 2}, 4);
    Walk masked(60, {-12, -1}, {11, 2}, 4);
    for (std::int32_t k = 0; k < 60; ++k) {
        scene.demand.push_back(k % 3 == 0 ? 0.0 : 1.0);
        masked.usable.push_back(k % 3 == 0 ? 0 : 1);
    }
    const auto plan = makeFastPlan();
    const auto expected = makeFastPlan();
    ThreadPool pool(1);
    for (int step = 0; step < 60; ++step) {
        const PlanResult result = scene.plan(*plan, pool);
        REQUIRE(result.cost == masked.plan(*expected, pool).cost);
        REQUIRE(result.flows.size() == 40);
        scene.take(result);
        masked.take(result);
        scene.walk(*plan, pool, 0.05);
        masked.characters = scene.characters;
    }
}

TEST_CASE("equal amounts of two units take the places of one unit each") {
    Walk scene(64, {-12, -1}, {11, 2}, 6);
    Walk plain(64, {-12, -1}, {11, 2}, 6);
    scene.supply.assign(64, 2.0);
    scene.demand.assign(64, 2.0);
    const auto plan = makeFastPlan();
    ThreadPool pool(1);
    PlanResult result;
    for (int step = 0; step < 60; ++step) {
        result = scene.plan(*plan, pool);
        scene.take(result);
    }
    const PlanResult best = plain.plan(*makeExactPlan(), pool);
    CHECK(result.flows.size() == 64);
    CHECK(amountOf(result) == doctest::Approx(128.0));
    CHECK(result.objective == doctest::Approx(2.0 * best.objective).epsilon(0.02));
}

TEST_CASE("a plan with weights that is restored goes on with the same bits, with any number of threads") {
    std::vector<std::uint64_t> outcomes;
    for (const std::int32_t threads : {1, 3}) {
        Walk scene = weighted(80, 7);
        ThreadPool pool(threads);
        auto plan = makeFastPlan();
        for (int step = 0; step < 150; ++step) {
            if (step % 40 == 13 && threads == 3) {
                Writer writer;
                plan->save(writer);
                auto copy = makeFastPlan();
                Reader reader(writer.bytes());
                REQUIRE(copy->load(reader, pool));
                copy->bind(scene.given());
                REQUIRE(hashOf(*copy) == hashOf(*plan));
                plan = std::move(copy);
            }
            if (step % 30 == 20) scene.demand[step % 7] = 0.3 * (step % 5);
            const PlanResult result = scene.plan(*plan, pool);
            const std::vector<std::int32_t> before = scene.incumbent;
            findMainPlaces(result.flows, before, scene.incumbent);
            scene.walk(*plan, pool, 0.05);
        }
        outcomes.push_back(hashOf(*plan));
    }
    CHECK(outcomes[0] == outcomes[1]);
}

TEST_CASE("fixed places keep all that their characters supply") {
    Walk scene = weighted(20, 9);
    ThreadPool pool(1);
    for (std::int32_t k = 0; k < 20; ++k) scene.incumbent[k] = k;
    scene.def.reassign = false;
    const auto plan = makeFastPlan();
    PlanResult fast;
    for (int step = 0; step < 40; ++step) fast = scene.plan(*plan, pool);  // Until it has its fields.
    const PlanResult exact = scene.plan(*makeExactPlan(), pool);
    REQUIRE(fast.flows.size() == exact.flows.size());
    for (std::size_t k = 0; k < fast.flows.size(); ++k) {
        CHECK(fast.flows[k].place == exact.flows[k].place);
        CHECK(fast.flows[k].amount == exact.flows[k].amount);
    }
    CHECK(fast.objective == doctest::Approx(exact.objective).epsilon(0.02));
}

TEST_CASE("one character supplies all places, and one place takes all characters") {
    ThreadPool pool(1);
    Walk one(9, {-12, -1}, {11, 2}, 10);
    one.supply = {9, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3};
    const auto plan = makeFastPlan();
    PlanResult result;
    for (int step = 0; step < 40; ++step) one.take(result = one.plan(*plan, pool));
    CHECK(amountOf(result) == doctest::Approx(9.0));
    CHECK(result.flows.size() >= 9);
    Walk all(9, {-12, -1}, {11, 2}, 11);
    all.demand = {0, 0, 0, 0, 20, 0, 0, 0, 0};
    const auto other = makeFastPlan();
    for (int step = 0; step < 40; ++step) all.take(result = all.plan(*other, pool));
    REQUIRE(result.flows.size() == 9);
    for (const Flow& flow : result.flows) CHECK(flow.place == 4);
    CHECK(amountOf(result) == doctest::Approx(9.0));
}

TEST_CASE("when characters leave or join, the plan goes on from the places that the others have") {
    ThreadPool pool(1);
    Walk scene = weighted(100, 12);
    const auto plan = makeFastPlan();
    PlanResult result;
    for (int step = 0; step < 200; ++step) {
        result = scene.plan(*plan, pool);
        const std::vector<std::int32_t> before = scene.incumbent;
        findMainPlaces(result.flows, before, scene.incumbent);
        scene.walk(*plan, pool, 0.05);
    }
    scene.characters.erase(scene.characters.begin() + 40);
    scene.supply.erase(scene.supply.begin() + 40);
    scene.incumbent.erase(scene.incumbent.begin() + 40);
    plan->forget();
    const std::vector<std::int32_t> held = scene.incumbent;
    for (int step = 0; step < 60; ++step) {
        result = scene.plan(*plan, pool);
        REQUIRE(feasible(scene, result));
        const std::vector<std::int32_t> before = scene.incumbent;
        findMainPlaces(result.flows, before, scene.incumbent);
    }
    int changed = 0;
    for (std::size_t i = 0; i < held.size(); ++i) changed += held[i] != scene.incumbent[i] ? 1 : 0;
    MESSAGE(changed << " of 99 go elsewhere after one has left");
    CHECK(changed <= 40);
    const Above above = aboveOf(scene, result, pool);
    CHECK(std::abs(above.missing) < 1e-5);
    CHECK(above.cost < 0.02);
}
