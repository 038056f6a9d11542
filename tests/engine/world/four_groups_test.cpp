// Groups that cross in the middle of an open square.
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Plays `only` (or all, where negative) of four groups of 90 that are ordered 80 m across; seconds until all
/// stand.
double play(std::int32_t only, RunFigures& figures) {
    WorldDef def{.box = {{-52, -52}, {52, 52}}};
    const Vec2 ways[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const double angles[] = {0.0, 3.14159265358979, 1.5707963267949, -1.5707963267949};
    std::vector<Vec2> goals;
    for (std::int32_t g = 0; g < 4; ++g) {
        if (only >= 0 && g != only) continue;
        GroupDef group{.count = 90, .position = ways[g] * -40.0, .angle = angles[g]};
        goals.push_back(ways[g] * 40.0);
        def.groups.push_back(group);
    }
    World world = World::create(def).value();
    RunMetrics metrics(world);
    for (std::size_t g = 0; g < goals.size(); ++g)
        REQUIRE(give(world, SetPose{world.group(g).id, goals[g], def.groups[g].angle}).ok());
    for (int s = 0; s < 120 * 60; ++s) {
        world.step();
        metrics.observe(world);
        if (s % 30 != 29 || !metrics.settled(world)) continue;
        figures = metrics.figures(world, false);
        return world.time();
    }
    return -1.0;
}

}  // namespace

TEST_CASE("four groups cross in the middle without overlap, not much later than each alone") {
    RunFigures alone, all;
    const double single = play(0, alone);
    const double together = play(-1, all);
    CAPTURE(single);
    CAPTURE(together);
    REQUIRE(single > 0.0);
    CHECK(together > 0.0);
    CHECK(together < 1.5 * single);
    CHECK(all.overlapPairsMax == 0);
}
