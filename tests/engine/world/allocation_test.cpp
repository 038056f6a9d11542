// A warm step allocates nothing: memory grows to what was needed at most and stays.
#include <doctest.h>

#include <cmath>

#include "base/neighbour_list.h"
#include "counting_new.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Allocations of 60 steps after as many warm ones.
long allocationsOf(World& world) {
    for (int s = 0; s < 120; ++s) world.step();
    const long before = allocations;
    for (int s = 0; s < 60; ++s) world.step();
    return allocations - before;
}

}  // namespace

TEST_CASE("the count sees what is allocated") {
    const long before = allocations;
    std::vector<int> some(100);
    CHECK(some.size() == 100);
    CHECK(allocations > before);
}

TEST_CASE("60 steps of a standing crowd allocate nothing") {
    World world = World::create(openFloor(36)).value();
    CHECK(allocationsOf(world) == 0);
}

TEST_CASE("60 steps of a standing crowd of several bodies, stances and drivers allocate nothing") {
    WorldDef def = openFloor(25);
    def.groups.push_back(def.groups[0]);
    def.groups[1].position = {6, 0};
    def.groups[0].bodies = {{.radius = 0.4, .maxSpeed = 1.5}};
    def.groups[0].conduct.stance = Stance::Hold;
    def.groups[1].conduct.cohesion = 0.7;
    World world = World::create(def).value();
    REQUIRE(world.submit({0, 1, 0, ChangeCharacters{{3}, {}, Driver::Outside}}).ok());
    CHECK(allocationsOf(world) == 0);
}

TEST_CASE("60 steps of people on their way to exits, and of those who wait and walk, allocate nothing") {
    WorldDef def = openFloor(36);
    def.box = {{-60, -12}, {60, 12}};
    AreaDef exit{.polygon = {{58, -4}, {60, -4}, {60, 4}, {58, 4}}};
    def.areas = {exit, exit, exit};
    for (Vec2& p : def.areas[1].polygon) p.x = -p.x;
    std::reverse(def.areas[1].polygon.begin(), def.areas[1].polygon.end());
    def.areas[2].kind = AreaKind::Waiting;
    for (Vec2& p : def.areas[2].polygon) p.x -= 10.0;
    def.groups.resize(3, def.groups[0]);
    def.groups[1].position = {-20, 0};
    def.groups[2].position = {20, 0};
    def.groups[0].orders = {Order::leave()};
    def.groups[0].orders[0].herding = 1.0;
    def.groups[1].orders = {Order::walk(1.0)};
    def.groups[2].orders = {Order::wait(AreaId{3})};
    World world = World::create(def).value();
    CHECK(allocationsOf(world) == 0);
}

TEST_CASE("60 steps of two formations that keep clear of each other allocate nothing") {
    WorldDef def = openFloor(16);
    def.box = {{-40, -20}, {40, 20}};
    def.groups.push_back(def.groups[0]);
    def.groups[0].orders = {Order::move({30, 0})};
    def.groups[1].orders = {Order::move({-30, 0})};
    def.groups[1].position = {6, 0};
    def.groups[1].angle = 3.0;
    for (GroupDef& group : def.groups) group.conduct.avoids = true;
    World world = World::create(def).value();
    CHECK(allocationsOf(world) == 0);
}

namespace {

/// Leads a crowd to and fro, `legs` times; allocations in the steps of the last two.
long leadToAndFro(const WorldDef& def, int legs) {
    World world = World::create(def).value();
    long inStep = 0;
    for (int leg = 0; leg < legs; ++leg) {
        const double from = leg % 2 == 0 ? -6.0 : 6.0;
        REQUIRE(give(world, Touch{TouchPhase::Down, 1, {from, 0}, world.time(), {}}).ok());
        world.step();
        REQUIRE(give(world, Touch{TouchPhase::Move, 1, {-from, 0}, world.time(), {}}).ok());
        world.step();
        REQUIRE(give(world, Touch{TouchPhase::Up, 1, {}, world.time(), {}}).ok());
        world.step();
        const long before = allocations;
        for (int s = 0; s < 900; ++s) world.step();
        if (leg >= legs - 2) inStep += allocations - before;
        CHECK(std::fabs(world.group(0).pose.position.x + from) < 0.5);  // It did walk.
    }
    return inStep;
}

}  // namespace

TEST_CASE("a crowd that walks where it walked before allocates nothing, in the open or round a block") {
    WorldDef def = openFloor(36);
    def.box = {{-15, -12}, {15, 12}};
    CHECK(leadToAndFro(def, 6) == 0);
    def.obstacles = {block(-1.2, -1.5, 1.2, 1.5)};
    CHECK(leadToAndFro(def, 12) == 0);
}

TEST_CASE("60 steps of two groups on patches, with items and checkpoints, allocate nothing") {
    WorldDef def = openFloor(25);
    def.patches = {rectangle(-11, -5, -1, 5, 3)};
    def.items = {{{10, 10}, 0.5}};
    def.checkpoints = {{.position = {10, -10}}};
    def.groups.push_back({.count = 16, .position = {6, 0}});
    World world = World::create(def).value();
    CHECK(allocationsOf(world) == 0);
}

TEST_CASE("neighbour lists allocate nothing more when a crowd spreads, however far") {
    Random random(3);
    std::vector<Vec2> positions;
    for (int k = 0; k < 60; ++k) positions.push_back({random.uniform(0, 3), random.uniform(0, 3)});
    NeighbourList list;
    list.build(positions, 0.65);
    const long before = allocations;
    for (int k = 0; k < 20; ++k) {
        for (Vec2& p : positions) p = {p.x * 1.5, p.y * 1.2};
        list.build(positions, 0.65);
    }
    CHECK(allocations == before);
}
