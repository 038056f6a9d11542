// The fast plan against the exact one, on the same ground.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include "engine/assignment/planning/walk_scene.h"

using namespace muster;
using namespace muster::test;
using muster_test::Walk;

TEST_CASE("the fast plan stays near the optimum while a crowd walks around a block") {
    Walk scene(144, {-12, -1}, {11, 2}, 3);
    const auto plan = makeFastPlan();
    ThreadPool pool(2);
    double worst = 0.0;
    double sum = 0.0;
    int samples = 0;
    for (int step = 0; step < 600; ++step) {
        scene.take(scene.plan(*plan, pool));
        scene.walk(*plan, pool, 0.05);
        for (Vec2& p : scene.places) p += Vec2{0.004, 0.006 * std::sin(0.01 * step)};
        if (step % 60 != 59) continue;
        const double gap = scene.gap(pool);
        worst = std::max(worst, gap);
        sum += gap;
        ++samples;
    }
    MESSAGE("gap mean " << sum / samples << ", worst " << worst);
    CHECK(worst < 0.01);
    CHECK(sum / samples < 0.005);
    double farthest = 0.0;
    for (std::size_t i = 0; i < scene.characters.size(); ++i)
        farthest = std::max(farthest, distance(scene.characters[i], scene.places[scene.incumbent[i]]));
    CHECK(farthest < 0.6);
}

TEST_CASE("the first plan takes every place once and reports its costs") {
    Walk scene(100, {-12, 0}, {12, 0}, 5);
    const auto fast = makeFastPlan();
    const auto exact = makeExactPlan();
    ThreadPool pool;
    PlanResult a = scene.plan(*fast, pool);
    CHECK(a.flows.size() == 100);
    CHECK(a.reassigned == 100);
    // The first plan is provisional until the fields are there that it needs; nobody waits for it meanwhile.
    for (int step = 0; step < 30 && a.provisional; ++step) {
        CHECK(a.first);
        scene.take(a);
        a = scene.plan(*fast, pool);
    }
    CHECK_FALSE(a.provisional);
    CHECK(a.first);
    std::fill(scene.incumbent.begin(), scene.incumbent.end(), -1);
    const PlanResult b = scene.plan(*exact, pool);
    REQUIRE(a.flows.size() == 100);
    std::vector<int> taken(100, 0);
    for (const Flow& flow : a.flows) ++taken[flow.place];
    CHECK(std::all_of(taken.begin(), taken.end(), [](int n) { return n == 1; }));
    double sum = 0.0;
    for (const double c : a.cost) sum += c * c;
    CHECK(a.objective == doctest::Approx(sum));
    // By exact costs the assignment is near the optimum. The plan's own costs are higher by what the coarse
    // ground adds at corners.
    scene.take(a);
    CHECK(scene.gap(pool) < 0.01);
    CHECK(a.objective == doctest::Approx(b.objective * (1.0 + scene.gap(pool))).epsilon(0.02));
}

TEST_CASE("the number of threads changes nothing") {
    std::vector<std::vector<std::int32_t>> outcomes;
    for (const std::int32_t threads : {1, 2, 3, 8}) {
        Walk scene(80, {-12, 0}, {10, 3}, 7);
        const auto plan = makeFastPlan();
        ThreadPool pool(threads);
        for (int step = 0; step < 120; ++step) {
            scene.take(scene.plan(*plan, pool));
            scene.walk(*plan, pool, 0.05);
        }
        Hasher hasher;
        plan->hash(hasher);
        outcomes.push_back(scene.incumbent);
        const std::uint64_t value = hasher.value();
        outcomes.back().push_back(static_cast<std::int32_t>(value));
        outcomes.back().push_back(static_cast<std::int32_t>(value >> 32));
        CHECK(outcomes.back() == outcomes.front());
    }
}

// A record of what is left holds against estimates, not against what happens to somebody.
TEST_CASE("who is put elsewhere on the way gets the place that is now nearest") {
    Walk scene(36, {-8, 0}, {8, 0}, 5);
    const auto plan = makeFastPlan();
    ThreadPool pool(1);
    const auto steps = [&](int count) {
        for (int k = 0; k < count; ++k) {
            scene.take(scene.plan(*plan, pool));
            scene.walk(*plan, pool, 0.05);
        }
    };
    steps(60);
    // Two change sides.
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < scene.characters.size(); ++i) {
        if (scene.characters[i].y < scene.characters[low].y) low = i;
        if (scene.characters[i].y > scene.characters[high].y) high = i;
    }
    std::swap(scene.characters[low], scene.characters[high]);
    const double before = scene.gap(pool);
    steps(20);
    CAPTURE(before);
    CHECK(scene.gap(pool) < 0.01);
}

TEST_CASE("reserved memory changes no plan") {
    Walk scene(90, {-12, 0}, {10, 3}, 5);
    const auto reserved = makeFastPlan();
    const auto bare = makeFastPlan();
    reserved->reserve(scene.characters.size(), scene.places.size(), scene.given());
    ThreadPool pool(2);
    CHECK_FALSE(reserved->pending());
    CHECK(reserved->suits(7, 3, scene.cost.grid));  // It has no plan yet.
    for (int step = 0; step < 40; ++step) {
        const PlanResult expected = scene.plan(*bare, pool);
        const PlanResult result = scene.plan(*reserved, pool);
        REQUIRE(result.cost == expected.cost);
        scene.take(expected);
        const std::vector<Vec2> before = scene.characters;
        scene.walk(*reserved, pool, 0.05);
        const std::vector<Vec2> after = std::exchange(scene.characters, before);
        scene.walk(*bare, pool, 0.05);
        REQUIRE(scene.characters == after);
        Hasher one;
        Hasher other;
        reserved->hash(one);
        bare->hash(other);
        REQUIRE(one.value() == other.value());
    }
}

TEST_CASE("background work during guidance gives the same plan as finish alone") {
    Walk scene(80, {-12, 0}, {10, 3}, 12);
    const auto background = makeFastPlan();
    const auto whole = makeFastPlan();
    ThreadPool pool(2);
    std::vector<Vec2> direction(80);
    std::vector<double> left(80);
    for (int step = 0; step < 60; ++step) {
        const PlanResult expected = scene.plan(*whole, pool);
        REQUIRE(background->start(scene.def, scene.input()).ok());
        CHECK(background->worksInBackground());
        background->advance(0, 1, pool);
        std::thread worker([&] { background->workInBackground(); });
        const GuidanceInput input{scene.characters, scene.incumbent, scene.places, &scene.given(), 1.5};
        background->guide(input, pool, direction, left);
        CHECK(background->pending());
        CHECK(background->waitingPlace(0) >= -1);
        worker.join();
        PlanResult result;
        REQUIRE(background->finish(pool, result).ok());
        CHECK_FALSE(background->pending());
        CHECK(result.objective == expected.objective);
        CHECK(result.cost == expected.cost);
        REQUIRE(result.flows.size() == expected.flows.size());
        for (std::size_t k = 0; k < result.flows.size(); ++k)
            REQUIRE(result.flows[k].place == expected.flows[k].place);
        whole->guide(input, pool, direction, left);
        scene.take(expected);
        // Guidance requests fields, so that both plans have to give the same.
        background->guide(input, pool, direction, left);
        scene.walk(*whole, pool, 0.05);
    }
    background->workInBackground();  // Has nothing to do.
    CHECK_FALSE(background->pending());
}

TEST_CASE("a saved fast plan continues bit for bit, a damaged one is refused") {
    Walk scene(60, {-12, 0}, {10, 3}, 8);
    const auto plan = makeFastPlan();
    ThreadPool pool;
    for (int step = 0; step < 70; ++step) {
        scene.take(scene.plan(*plan, pool));
        scene.walk(*plan, pool, 0.05);
    }
    Writer writer;
    plan->save(writer);
    const auto copy = makeFastPlan();
    Reader reader(writer.bytes());
    REQUIRE(copy->load(reader, pool));
    CHECK(copy->suits(60, 60, scene.environment.grid()));
    CHECK_FALSE(copy->suits(61, 61, scene.environment.grid()));
    Walk other = Walk(60, {-12, 0}, {10, 3}, 8);
    other.characters = scene.characters;
    other.incumbent = scene.incumbent;
    for (int step = 0; step < 60; ++step) {
        scene.take(scene.plan(*plan, pool));
        other.take(other.plan(*copy, pool));
        REQUIRE(scene.incumbent == other.incumbent);
        scene.walk(*plan, pool, 0.05);
        other.walk(*copy, pool, 0.05);
        REQUIRE(scene.characters == other.characters);
    }
    for (const std::size_t size : {std::size_t{3}, writer.bytes().size() / 3, writer.bytes().size() - 2}) {
        Reader cut(std::span(writer.bytes()).first(size));
        CHECK_FALSE(makeFastPlan()->load(cut, pool));
    }
}

TEST_CASE("fixed places are kept, and the unmatched wait near a usable place") {
    Walk scene(40, {-12, 0}, {10, 3}, 9);
    for (std::size_t i = 0; i < 40; ++i) scene.incumbent[i] = static_cast<std::int32_t>(39 - i);
    scene.def.reassign = false;
    const auto plan = makeFastPlan();
    ThreadPool pool;
    const PlanResult fixed = scene.plan(*plan, pool);
    REQUIRE(fixed.flows.size() == 40);
    for (const Flow& flow : fixed.flows) CHECK(flow.place == 39 - flow.character);
    CHECK(fixed.reassigned == 0);

    scene.def.reassign = true;
    scene.usable.assign(40, 1);
    for (std::size_t j = 0; j < 12; ++j) scene.usable[j] = 0;
    const PlanResult fewer = scene.plan(*plan, pool);
    CHECK(fewer.flows.size() == 28);
    int waiting = 0;
    for (std::int32_t i = 0; i < 40; ++i) {
        if (std::isfinite(fewer.cost[i])) continue;
        const std::int32_t place = plan->waitingPlace(i);
        REQUIRE(place >= 0);
        CHECK(scene.usable[place] == 1);
        ++waiting;
    }
    CHECK(waiting == 12);
}

TEST_CASE("inputs that a fast plan cannot serve are refused") {
    const Walk scene(20, {-12, 0}, {10, 3}, 10);
    const auto plan = makeFastPlan();
    PlanInput input = scene.input();
    std::vector<double> amounts(20, 1.5);
    amounts[3] = -1.0;
    input.supply = amounts;
    CHECK(plan->start(scene.def, input).message().find("supply 3") != std::string::npos);
    input = scene.input();
    input.costs = nullptr;
    CHECK_FALSE(plan->start(scene.def, input).ok());
    ThreadPool pool;
    PlanResult result;
    CHECK_FALSE(plan->finish(pool, result).ok());
    CHECK(plan->waitingPlace(5) == -1);
    CHECK_FALSE(std::isfinite(plan->costAt(0, {0, 0})));
}
