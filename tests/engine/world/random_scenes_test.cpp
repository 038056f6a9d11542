// Property: whatever scene and whatever fingers, nobody ends in an obstacle or in another, and no number
// breaks.
#include <doctest.h>
#include <rapidcheck.h>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("random scenes under random fingers keep every invariant") {
    const bool holds = rc::check("no NaN, nobody in an obstacle, no overlap", [] {
        // Who stands where an obstacle is put has this long to leave it: 0.65 m at 2 m/s, and 1 s.
        constexpr int kLeaving = 80;
        int leaving = 0;
        const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1u << 20);
        World world = World::create(busyFloor(seed)).value();
        RandomDirector director(seed * 7 + 1);
        for (int s = 0; s < 150; ++s) {
            director.act(world);
            const std::size_t obstacles = world.obstacleIds().size();
            world.step();
            leaving = world.obstacleIds().size() > obstacles ? kLeaving : leaving - 1;
            const CharactersView c = world.characters();
            for (std::size_t i = 0; i < c.size(); ++i) {
                RC_ASSERT(isFinite(c.position[i]) && isFinite(c.velocity[i]) && isFinite(c.heading[i]));
                RC_ASSERT(inspect::environment(world).def().box.contains(c.position[i]));
                RC_ASSERT(leaving > 0 || inspect::environment(world).distanceToObstacle(c.position[i]) >
                                             world.parameters().character.radius - 1e-3);
            }
            RC_ASSERT(leaving > 0 || world.contacts().overlapPairs == 0);
            for (std::size_t g = 0; g < world.groupCount(); ++g)
                for (const Vec2 v : world.group(g).finalMesh) RC_ASSERT(isFinite(v));
        }
        for (int s = 0; s < 60; ++s) world.step();
        RC_ASSERT(world.contacts().overlapPairs == 0);
    });
    CHECK(holds);
}
