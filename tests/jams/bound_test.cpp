// The bound by which jams are judged, itself against cases that can be computed by hand.
#include <doctest.h>

#include <cstdio>
#include <filesystem>

#include "jams/jam_files.h"
#include "jams/quickest_flow.h"
#include "jams/random_jams.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

#if MUSTER_HAS_LEMON

TEST_CASE("visibility graph: straight in sight, round the end of a wall out of sight") {
    WallPlan plan{.box = {{-20, -20}, {20, 20}}};
    const VisibilityGraph graph({wallPart(plan, -5.0, 3.0)});
    const Vec2 from{-4.5, 0.0};
    const std::vector<double> lengths = graph.lengthsFrom(from);
    CHECK(graph.lengthTo({-4.5, 9.0}, from, lengths) == doctest::Approx(9.0));
    CHECK(graph.lengthTo({4.5, 0.0}, from, lengths) == doctest::Approx(5.0 + 1.0 + 5.0).epsilon(1e-4));
}

TEST_CASE("quickest flow: one passage is walk, service and walk; two equal ones halve the service") {
    WallPlan plan{.openings = {{-0.5, 0.5}}, .box = {{-40, -40}, {40, 40}}};
    JamScene scene = sceneOf(plan);
    scene.shift = {20.5, 0.0};
    const std::vector<Vec2> starts(90, Vec2{-10.0, 0.0});
    // 5 s to the middle of the wall, 89 more slots of 1 / 4.5 s, 5.25 s on.
    CHECK(quickestFlow(scene, starts) == doctest::Approx(5.0 + 89 / 4.5 + 5.25).epsilon(0.01));
    plan.openings = {{-1.5, -0.5}, {0.5, 1.5}};
    scene = sceneOf(plan);
    scene.shift = {20.5, 0.0};
    CHECK(quickestFlow(scene, starts) == doctest::Approx(5.0 + 44 / 4.5 + 5.25).epsilon(0.02));
}

TEST_CASE("quickest flow of the three jams") {
    const double expected[] = {12.6, 15.5, 22.7};
    for (int k = 0; k < 3; ++k) {
        const auto scene = jamFile(k);
        if (!scene) return;
        const double bound = quickestFlowAfterCommands(*scene, startsOf(*scene));
        std::printf("J%d: quickest flow %.1f s after the last command\n", k + 1, bound);
        CHECK(bound == doctest::Approx(expected[k]).epsilon(0.03));
    }
}

TEST_CASE("random jams: in each the nearest passage alone takes at least 1.3 times the bound") {
    for (std::uint64_t seed = 1; seed <= kRandomJams; ++seed) {
        const JamScene scene = randomJam(seed);
        CHECK(scene.passages.size() >= 2);
        std::printf("jam %d: %d people, widths", static_cast<int>(seed), scene.def.groups[0].count);
        for (const JamPassage& passage : scene.passages) std::printf(" %.2f", passage.width());
        std::printf(", bound %.1f s\n", quickestFlowAfterCommands(scene, startsOf(scene)));
    }
}

#else

TEST_CASE("quickest flow") {
    MESSAGE("skipped: liblemon-dev is not installed");
}

#endif
