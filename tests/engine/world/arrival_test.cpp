// Everybody arrives in random scenes, without overlap and at no more than top speed. By default two of each
// family and those that once failed; MUSTER_SCENES=first:count plays so many of each family and prints those
// that fail.
#include <doctest.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "engine/world/dragged_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kTopSpeedRatio = 1.05;  // Nobody is faster than so many times its top speed.

void playAll(SceneFamily family, const char* name, std::vector<int> seeds) {
    const char* asked = std::getenv("MUSTER_SCENES");
    int first = 1, count = 0;
    if (asked != nullptr && std::sscanf(asked, "%d:%d", &first, &count) == 2) {
        seeds.resize(count);
        std::iota(seeds.begin(), seeds.end(), first);
    }
    int failed = 0, overlapping = 0;
    double fastest = 0.0, deepest = 0.0;
    for (const int seed : seeds) {
        CAPTURE(name);
        CAPTURE(seed);
        const SceneOutcome outcome = play(family, static_cast<std::uint64_t>(seed));
        CHECK(outcome.notArrived == 0);
        CHECK(outcome.figures.overlapPairsMax == 0);
        CHECK(outcome.figures.topSpeedRatio <= kTopSpeedRatio);
        fastest = std::max(fastest, outcome.figures.topSpeedRatio);
        deepest = std::max(deepest, outcome.figures.worstPenetration);
        failed += outcome.notArrived > 0 ? 1 : 0;
        overlapping += outcome.figures.overlapPairsMax > 0 ? 1 : 0;
        if (asked != nullptr && (outcome.notArrived > 0 || outcome.figures.overlapPairsMax > 0))
            std::printf("%s %d: %d of %d not arrived, %d unmatched, deepest %.3f\n", name, seed,
                        outcome.notArrived, outcome.figures.characters, outcome.figures.unmatched,
                        outcome.figures.worstPenetration);
    }
    if (asked != nullptr)
        std::printf(
            "%s: %zu scenes, %d with somebody not arrived, %d with overlap, deepest %.3f, top speed %.3f\n",
            name, seeds.size(), failed, overlapping, deepest, fastest);
}

}  // namespace

TEST_CASE("everybody arrives among sparse obstacles") {
    playAll(SceneFamily::Sparse, "sparse", {1, 2, 180});
}

TEST_CASE("everybody arrives among dense obstacles") {
    playAll(SceneFamily::Dense, "dense",
            {1, 2, 20, 78, 154, 182, 188, 198, 242, 412, 495, 572, 576, 621, 789});
}

TEST_CASE("everybody arrives where two groups cross") {
    playAll(SceneFamily::Crossing, "crossing", {1, 2, 56});
}
