// Places that find no room where the mesh is, and places that do not fit at all.
#include <doctest.h>

#include <algorithm>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("where a dead end is full the others get places before it, and one behind a wall comes round it") {
    WorldDef def{.box = {{-20, -12}, {20, 12}}};
    // A dead end with places for some, and a wall before the last character.
    def.obstacles = {block(5, 0.5, 20, 12), block(5, -12, 20, -0.5), block(-9, -8, -8, 8)};
    GroupDef group{.count = 40, .position = {16, 0}};
    for (int i = 0; i < 39; ++i) group.starts.push_back({(i % 6) * 0.8, -3 + (i / 6) * 0.8});
    group.starts.push_back({-14, 0});
    def.groups = {group};
    World world = World::create(def).value();
    for (int s = 0; s < 25 * 60; ++s) world.step();
    const CharactersView c = world.characters();
    std::ptrdiff_t inside = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        CAPTURE(i);
        REQUIRE(c.place[i] >= 0);
        CHECK(c.position[i].x > 0.0);
        inside += c.position[i].x > 5.0 ? 1 : 0;
    }
    CHECK(inside > 10);
    CHECK(inside < 40);
}

TEST_CASE("last places that do not fit are nobody's, and their holders' again when they fit") {
    for (const PlanMode mode : {PlanMode::AssignedOnce, PlanMode::Fixed}) {
        CAPTURE(mode);
        WorldDef def{.box = {{-4, -2}, {4, 2}}};
        def.parameters.plan.mode = mode;
        GroupDef group{.count = 12, .formation = {.spacing = 0.9}};
        def.groups = {group};
        World world = World::create(def).value();
        world.step();
        const auto first = copyOf(world.characters().place);
        CHECK(std::count(first.begin(), first.end(), -1) == 0);
        REQUIRE(give(world, putThing(block(-4, -2, 3.2, 2))).ok());  // A strip is left.
        for (int s = 0; s < 40; ++s) world.step();
        const auto fit = world.group(0).placeUsable;
        const auto fitting = std::count(fit.begin(), fit.end(), 1);
        REQUIRE(fitting < 12);
        const auto crowded = copyOf(world.characters().place);
        CHECK(std::count(crowded.begin(), crowded.end(), -1) == 12 - fitting);
        world = World::restore(world.snapshot()).value();
        REQUIRE(give(world, removeThing(world.obstacleIds()[0])).ok());
        for (int s = 0; s < 60; ++s) world.step();
        CHECK(copyOf(world.characters().place) == first);
    }
}
