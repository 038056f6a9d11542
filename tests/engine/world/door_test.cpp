// A crowd before a door: nobody's press may wedge it for good.
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A hall cut by a wall with one door of `width` [m]; 36 stand close before it, their places behind.
WorldDef hall(double width, std::uint64_t seed) {
    WorldDef def{.box = {{-12, -8}, {14, 8}},
                 .seed = seed,
                 .obstacles = {block(-0.5, -8, 0.5, -0.5 * width), block(-0.5, 0.5 * width, 0.5, 8)}};
    GroupDef group{.position = {8, 0}, .jitter = 0.1};
    for (int i = 0; i < 36; ++i) group.starts.push_back({-1.5 - 0.6 * (i / 6), 0.6 * (i % 6 - 2.5)});
    def.groups.push_back(group);
    // By costs alone they would wait for each other; here they press.
    def.parameters.density.enabled = false;
    def.parameters.field.enabled = false;
    return def;
}

}  // namespace

TEST_CASE("a crowd passes a door that is wider than one and narrower than two") {
    for (const double width : {0.7, 0.8, 0.95}) {
        // By luck some seeds pass without any rule.
        for (std::uint64_t seed = 1; seed <= (width == 0.8 ? 9 : 3); ++seed) {
            CAPTURE(width);
            CAPTURE(seed);
            World world = World::create(hall(width, seed)).value();
            RunMetrics metrics(world);
            while (world.time() < 60.0 && !(world.stepCount() % 30 == 29 && metrics.settled(world))) {
                world.step();
                metrics.observe(world);
            }
            const RunFigures figures = metrics.figures(world, false);
            CHECK(figures.arrived100 > 0.0);
            CHECK(figures.arrived100 < 45.0);
            CHECK(figures.stuck == 0);
            CHECK(figures.overlapPairsMax == 0);
        }
    }
}

TEST_CASE("who holds back before a door depends on nothing but the state, also with more headway") {
    World world = World::create(hall(0.8, 1)).value();
    for (int s = 0; s < 120; ++s) world.step();  // They touch before the door.
    REQUIRE(world.submit({120, 1, 0, SetParameter{"character.headway", 0.5}}).ok());
    REQUIRE(world.submit({120, 1, 1, ChangeGroup{.group = world.group(0).id, .count = 20}}).ok());
    for (int s = 0; s < 5; ++s) world.step();
    checkGoesOn(world, 120);
}
