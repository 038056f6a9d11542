// Two groups meet at a door that is one wide: they take turns.
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Plays one or both of two groups of `count` on either side of a wall of 1 m with a door of `width` [m],
/// each ordered to the other side; seconds until all stand, negative where they do not within `most` [s].
double play(double width, std::int32_t count, bool left, bool right, double most) {
    WorldDef def{.box = {{-20, -10}, {20, 10}},
                 .obstacles = {block(-0.5, -10, 0.5, -0.5 * width), block(-0.5, 0.5 * width, 0.5, 10)}};
    std::vector<Vec2> goals;
    for (const double side : {-1.0, 1.0}) {
        if (side < 0 ? !left : !right) continue;
        def.groups.push_back(
            {.count = count, .position = {8 * side, 0}, .angle = side < 0 ? 0.0 : 3.14159265358979});
        goals.push_back({-8 * side, 0});
    }
    World world = World::create(def).value();
    RunMetrics metrics(world);
    for (std::size_t g = 0; g < goals.size(); ++g)
        REQUIRE(give(world, SetPose{world.group(g).id, goals[g], def.groups[g].angle}).ok());
    while (world.time() < most) {
        world.step();
        metrics.observe(world);
        if (world.stepCount() % 30 == 0 && metrics.settled(world)) return world.time();
    }
    return -1.0;
}

}  // namespace

TEST_CASE("two groups that meet at a door for one all pass, in at most 1.5 times the time of both alone") {
    const double left = play(0.55, 60, true, false, 120), right = play(0.55, 60, false, true, 120);
    REQUIRE(left > 0.0);
    REQUIRE(right > 0.0);
    const double both = play(0.55, 60, true, true, 240);
    CAPTURE(left);
    CAPTURE(right);
    CAPTURE(both);
    CHECK(both > 0.0);
    CHECK(both < 1.5 * (left + right));
}
