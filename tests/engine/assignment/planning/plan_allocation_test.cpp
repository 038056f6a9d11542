// A plan that is made again and again allocates nothing once warm.
#include <doctest.h>

#include "counting_new.h"
#include "engine/assignment/planning/plan_scene.h"
#include "engine/assignment/transport/dynamic/assignment_scene.h"
#include "engine/assignment/transport/dynamic/dynamic_transport.h"

TEST_CASE("a warm plan allocates nothing") {
    muster::Random random(12);
    auto ground = muster_test::uniformGround({{-8, -8}, {8, 8}}, 0.25);
    muster_test::addWall(ground, {{-1, -6}, {1, 6}});
    muster_test::addWall(ground, {{5, 5}, {8, 5.3}});
    muster_test::addWall(ground, {{5, 5}, {5.3, 8}});
    auto input = muster_test::randomInput(random, ground, 20, {{-7, -7}, {-2, 7}}, {{2, -7}, {7, 7}});
    const auto plan = muster::makeExactPlan();
    muster::ThreadPool pool(1);
    muster::PlanResult result;
    for (int k = 0; k < 8; ++k) {
        for (auto& p : input.characters) p.x = -7.0 + 5.0 * ((k % 3) * 0.3 + 0.1);
        const long before = allocations;
        REQUIRE(plan->start({}, input.view()).ok());
        plan->advance(0, 3, pool);
        REQUIRE(plan->finish(pool, result).ok());
        // Both buffers have seen all three positions of the crowd by then.
        if (k >= 6) CHECK(allocations == before);
        CHECK(allocations > 0);
    }
}

TEST_CASE("a warm dynamic assignment allocates nothing") {
    muster_test::AssignmentScene scene(200, 200, 3);
    scene.costs.wall = true;
    scene.usable.assign(200, 1);
    muster::ThreadPool pool(1);
    muster::DynamicAssignment assignment;
    assignment.coldStart(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
    long inside = 0;
    for (int k = 0; k < 240; ++k) {
        if (k % 5 == 0) scene.usable[scene.random.below(8)] ^= 1;
        scene.step({1.3, 0.2}, 0.05, assignment.placeOf());
        const long before = allocations;
        assignment.update(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
        if (k >= 10) inside += allocations - before;
    }
    CHECK(inside == 0);
}

TEST_CASE("a warm transport allocates nothing") {
    muster_test::AssignmentScene scene(200, 200, 3);
    scene.costs.wall = true;
    std::vector<double> supply, demand;
    for (int k = 0; k < 200; ++k) {
        supply.push_back(0.25 * (1 + scene.random.below(12)));
        demand.push_back(0.25 * scene.random.below(13));
    }
    muster::ThreadPool pool(1);
    muster::DynamicTransport transport;
    std::vector<std::int32_t> place(200, -1);
    long inside = 0;
    for (int k = 0; k < 240; ++k) {
        const muster::AssignmentInput positions = scene.input();
        const long before = allocations;
        transport.update({positions, supply, demand, {}, 2.0}, scene.costs, pool);
        if (k >= 60) inside += allocations - before;
        for (const muster::Flow& flow : transport.flows()) place[flow.character] = flow.place;
        scene.step({1.3, 0.2}, 0.05, place);
    }
    CHECK(inside == 0);
}
