// Groups that are led to one spot settle side by side and stand still.
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

void addSquare(WorldDef& def, std::int32_t count, Vec2 position, double angle) {
    def.groups.push_back({.count = count, .position = position, .angle = angle});
}

}  // namespace

TEST_CASE("two groups ordered onto one spot settle side by side and stand still") {
    WorldDef def{.box = {{-30, -20}, {30, 20}}};
    addSquare(def, 60, {-15, 0}, 0.0);
    addSquare(def, 60, {15, 0}, 0.0);
    World world = World::create(def).value();
    RunMetrics metrics(world);
    REQUIRE(give(world, SetPose{world.group(0).id, {0, 0}, 0.0}).ok());
    REQUIRE(give(world, SetPose{world.group(1).id, {0, 0}, 0.0}).ok());
    for (int s = 0; s < 30 * 60; ++s) {
        world.step();
        metrics.observe(world);
    }
    CHECK(metrics.notArrived(world) == 0);
    CHECK(metrics.figures(world, false).overlapPairsMax == 0);
    for (const Vec2 v : world.characters().velocity) CHECK(length(v) < 0.02);
    for (const Vec2 p : world.group(0).placePositions)
        for (const Vec2 q : world.group(1).placePositions) CHECK(distance(p, q) > 0.5);
    // Led away, the group has its mesh again.
    REQUIRE(give(world, SetPose{world.group(1).id, {15, 0}, 0.0}).ok());
    for (int s = 0; s < 15 * 60; ++s) world.step();
    Vec2 mean;
    for (const Vec2 p : world.group(1).placePositions) mean += p / 60.0;
    CHECK(distance(mean, {15, 0}) < 0.3);
}
