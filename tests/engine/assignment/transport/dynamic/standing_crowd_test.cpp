// Dynamic assignment of a crowd that stands still: it reaches the optimum but for what the threshold keeps
// back.
#include <doctest.h>

#include "engine/assignment/transport/dynamic/assignment_scene.h"

namespace {

using muster::DynamicAssignment;
using muster_test::AssignmentScene;

struct Outcome {
    double first = 0.0;  // Objective after the cold start.
    double last = 0.0;   // Objective after the last step.
    double optimum = 0.0;
    long lateExchanges = 0;  // In the second half of the steps.
};

// Nobody moves for so many steps.
Outcome stand(AssignmentScene& scene, const muster::DynamicAssignmentDef& def, int steps) {
    DynamicAssignment assignment;
    muster::ThreadPool pool(1);
    assignment.coldStart(def, scene.input(), scene.costs, pool);
    Outcome outcome{.first = scene.objective(assignment.placeOf(), def.exponent)};
    for (int k = 0; k < steps; ++k) {
        assignment.update(def, scene.input(), scene.costs, pool);
        if (2 * k > steps) outcome.lateExchanges += assignment.exchanges();
    }
    REQUIRE(scene.valid(assignment.placeOf()));
    outcome.last = scene.objective(assignment.placeOf(), def.exponent);
    outcome.optimum = scene.optimum(def.exponent);
    return outcome;
}

muster::DynamicAssignmentDef productThresholds(double exponent) {
    return {.exponent = exponent, .threshold = 0.02, .thresholdShare = 0.003};
}

}  // namespace

TEST_CASE("a standing crowd near its places finds all exchanges that gain enough, and then no more") {
    for (const std::uint64_t seed : {3, 4, 5}) {
        AssignmentScene scene(220, 220, seed, 0.0);
        const Outcome outcome = stand(scene, productThresholds(2.0), 500);
        CAPTURE(seed);
        CAPTURE(outcome.first / outcome.optimum);
        CHECK(outcome.last >= outcome.optimum - 1e-6);
        CHECK(outcome.last <= outcome.first + 1e-6);
        CHECK((outcome.last - outcome.optimum) / std::max(outcome.optimum, 220 * 0.0625) < 0.005);
        CHECK(outcome.lateExchanges == 0);
    }
}

TEST_CASE("a standing crowd behind a wall reaches the optimum, whatever the exponent") {
    for (const double exponent : {1.0, 1.5, 2.0, 3.0}) {
        AssignmentScene scene(200, 200, 17, 3.0);
        scene.costs.wall = true;
        scene.costs.low = {-1.0, -3.0};
        scene.costs.high = {-1.0, 4.0};
        const Outcome outcome = stand(scene, productThresholds(exponent), 600);
        CAPTURE(exponent);
        CHECK(outcome.last >= outcome.optimum * (1.0 - 1e-9));
        CHECK((outcome.last - outcome.optimum) / outcome.optimum < 0.005);
    }
}

TEST_CASE("a standing crowd reaches the optimum with more characters than places, and with fewer") {
    for (const std::int32_t places : {150, 200, 260}) {
        AssignmentScene scene(200, places, 23, 1.0);
        const Outcome outcome = stand(scene, productThresholds(2.0), 600);
        CAPTURE(places);
        CHECK(outcome.last >= outcome.optimum - 1e-6);
        CHECK((outcome.last - outcome.optimum) / std::max(outcome.optimum, 200 * 0.0625) < 0.01);
    }
}
