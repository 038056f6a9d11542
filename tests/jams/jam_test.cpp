// Crowds before passages, against the quickest flow (SPEC A8).
#include <doctest.h>

#include <cstdio>
#include <cstdlib>

#include "jams/jam_run.h"
#include "jams/random_jams.h"

using namespace muster;
using namespace muster::testing;

#if MUSTER_HAS_LEMON

namespace {

constexpr double kOverBound = 1.15;  // Last arrival over the quickest flow, at most.

/// Runs a scene and prints how near it came to the bound.
double overBound(const char* name, const JamScene& scene) {
    const double bound = quickestFlowAfterCommands(scene, startsOf(scene));
    const JamRun run = runJam(scene);
    std::printf("%s: %d people, last %.1f s, bound %.1f s, %.2f; through", name, scene.def.groups[0].count,
                run.last, bound, run.last / bound);
    for (std::size_t p = 0; p < run.through.size(); ++p)
        std::printf(" %d by %.1f m", run.through[p], scene.passages[p].width());
    std::printf("\n");
    std::fflush(stdout);
    return run.last < 0.0 ? 1e9 : run.last / bound;
}

}  // namespace

TEST_CASE("short random jams come near the quickest flow") {
    for (const std::uint64_t seed : {2, 6, 15, 16, 17})
        CHECK(overBound("jam", randomJam(seed)) <= kOverBound);
}

// On request: engine_tests --no-skip --test-case="the three jams*"
TEST_CASE("the three jams come near the quickest flow" * doctest::skip()) {
    const char* names[] = {"J1", "J2", "J3"};
    for (int k = 0; k < 3; ++k)
        if (const auto scene = jamFile(k)) CHECK(overBound(names[k], *scene) <= kOverBound);
}

// On request: engine_tests --no-skip --test-case="opening a passage*"
TEST_CASE("opening a passage delays the last arrival by at most 3 %" * doctest::skip()) {
    for (std::uint64_t seed = 1; seed <= kRandomJams; ++seed) {
        const JamScene scene = randomJam(seed);
        const double all = runJam(scene).last;
        for (std::size_t closed = 0; closed < scene.passages.size(); ++closed) {
            const double without = runJam(withoutPassage(scene, closed)).last;
            std::printf("jam %d: %.1f s, without passage %d %.1f s\n", static_cast<int>(seed), all,
                        static_cast<int>(closed), without);
            std::fflush(stdout);
            CHECK(all >= 0.0);
            CHECK((without < 0.0 || all <= 1.03 * without));
        }
    }
}

// On request, to look at them: JAMS=FOLDER engine_tests --no-skip --test-case="random jams as files"
TEST_CASE("random jams as files" * doctest::skip()) {
    const char* folder = std::getenv("JAMS");
    REQUIRE(folder != nullptr);
    for (std::uint64_t seed = 1; seed <= kRandomJams; ++seed) {
        const JamScene scene = randomJam(seed);
        const std::string path = std::string(folder) + "/jam" + std::to_string(seed);
        CHECK(saveScenario(scene.def, path + ".json").ok());
        CHECK(saveGestures(scene.commands, scene.def.parameters.stepTime, path + ".gestures.json").ok());
    }
}

// On request: engine_tests --no-skip --test-case="twenty random jams*"
TEST_CASE("twenty random jams come near the quickest flow" * doctest::skip()) {
    for (std::uint64_t seed = 1; seed <= kRandomJams; ++seed) {
        char name[16];
        std::snprintf(name, sizeof name, "jam %d", static_cast<int>(seed));
        CHECK(overBound(name, randomJam(seed)) <= kOverBound);
    }
}

#endif
