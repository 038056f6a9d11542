// A crowd that stands still is brought to the optimum but for what the threshold keeps back.
#include <doctest.h>

#include "assignment/dynamic/assignment_scene.h"

namespace {

using muster::DynamicAssignment;
using muster_test::AssignmentScene;

struct Rest {
    double first = 0.0;  // Of the start.
    double last = 0.0;
    double optimum = 0.0;
    long late = 0;  // Changes in the second half.
};

// Nobody moves; the matching goes on for so many steps.
Rest stand(AssignmentScene& scene, const muster::DynamicAssignmentDef& def, int steps) {
    DynamicAssignment matching;
    muster::ThreadPool pool(1);
    matching.coldStart(def, scene.input(), scene.costs, pool);
    Rest rest;
    rest.first = scene.objective(matching.placeOf(), def.exponent);
    for (int k = 0; k < steps; ++k) {
        matching.update(def, scene.input(), scene.costs, pool);
        if (2 * k > steps) rest.late += matching.exchanges();
    }
    REQUIRE(scene.valid(matching.placeOf()));
    rest.last = scene.objective(matching.placeOf(), def.exponent);
    rest.optimum = scene.optimum(def.exponent);
    return rest;
}

muster::DynamicAssignmentDef lowThreshold(double exponent) {
    muster::DynamicAssignmentDef def;
    def.exponent = exponent;
    def.threshold = 0.02;
    def.thresholdShare = 0.003;
    return def;
}

}  // namespace

TEST_CASE("standing beside their places all exchanges that gain enough are found, and then no more") {
    for (const std::uint64_t seed : {3, 4, 5}) {
        AssignmentScene scene(220, 220, seed, 0.0);
        const Rest rest = stand(scene, lowThreshold(2.0), 500);
        CAPTURE(seed);
        CAPTURE(rest.first / rest.optimum);
        CHECK(rest.last >= rest.optimum - 1e-6);
        CHECK(rest.last <= rest.first + 1e-6);
        CHECK((rest.last - rest.optimum) / std::max(rest.optimum, 220 * 0.0625) < 0.005);
        CHECK(rest.late == 0);
    }
}

TEST_CASE("so with a wall between some and their places, whatever the exponent") {
    for (const double exponent : {1.0, 1.5, 2.0, 3.0}) {
        AssignmentScene scene(200, 200, 17, 3.0);
        scene.costs.wall = true;
        scene.costs.low = {-1.0, -3.0};
        scene.costs.high = {-1.0, 4.0};
        const Rest rest = stand(scene, lowThreshold(exponent), 600);
        CAPTURE(exponent);
        CHECK(rest.last >= rest.optimum * (1.0 - 1e-9));
        CHECK((rest.last - rest.optimum) / rest.optimum < 0.005);
    }
}

TEST_CASE("so with more people than places, and with fewer") {
    for (const std::int32_t places : {150, 200, 260}) {
        AssignmentScene scene(200, places, 23, 1.0);
        const Rest rest = stand(scene, lowThreshold(2.0), 600);
        CAPTURE(places);
        CHECK(rest.last >= rest.optimum - 1e-6);
        CHECK((rest.last - rest.optimum) / std::max(rest.optimum, 200 * 0.0625) < 0.01);
    }
}
