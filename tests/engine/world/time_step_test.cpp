// Time steps of 10 to 240 per second: crossing crowds without deep overlaps, and all arrive.
#include <doctest.h>

#include "engine/ground/environment/environment.h"
#include "engine/systems/steering/contact_stage.h"
#include "engine/world/inspect.h"
#include "engine/world/played.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("characters move in parts of at most a thirtieth of a second") {
    CHECK(movesOf(1.0 / 240) == 1);
    CHECK(movesOf(1.0 / 60) == 1);
    CHECK(movesOf(1.0 / 30) == 1);
    CHECK(movesOf(1.0 / 24) == 2);
    CHECK(movesOf(1.0 / 20) == 2);
    CHECK(movesOf(1.0 / 15) == 2);
    CHECK(movesOf(1.0 / 10) == 3);
}

TEST_CASE("at every rate from 10 to 240 Hz crowds cross, none deep in another or in walls, and arrive") {
    for (const double rate : {10.0, 15.0, 20.0, 24.0, 30.0, 60.0, 120.0, 240.0}) {
        CAPTURE(rate);
        WorldDef def{.box = {{-18, -18}, {18, 18}},
                     .obstacles = {block(-1, 3, 1, 6), tree({2, -3}, 0.7)},
                     .parameters = {.stepTime = 1.0 / rate}};
        const Vec2 starts[] = {{-11, 0}, {11, 1}, {0, -12}};
        for (const Vec2 start : starts)
            def.groups.push_back({.count = rate > 100.0 ? 16 : 36, .position = start});
        Played played(def);
        for (std::uint32_t g = 0; g < 3; ++g) played.give(SetPose{GroupId{g + 1}, starts[g] * -1.0, 0.0});
        const int seconds = rate > 100.0 ? 30 : 40;
        for (int s = 0; s < 5 * seconds; ++s) {
            played.run(0.2);
            const CharactersView c = played.world.characters();
            for (const Vec2 p : c.position)
                CHECK(inspect::environment(played.world).distanceToObstacle(p) > 0.25 - 2e-3);
        }
        CHECK(played.deepest <= 0.1);
        for (const std::size_t group : {0, 1, 2}) CHECK(played.farthest(group) < 0.5);
    }
}

TEST_CASE("a step longer than a tenth of a second, or shorter than 1/240, is refused") {
    WorldDef def = openFloor(4);
    def.parameters.stepTime = 0.11;
    CHECK(!World::create(def).ok());
    def.parameters.stepTime = 1.0 / 250;
    CHECK(!World::create(def).ok());
    def.parameters.stepTime = 0.1;
    CHECK(World::create(def).ok());
}
