// Who holds its ground is ground to others, who is idle makes room, and large bodies go before small ones.
#include <doctest.h>

#include <cmath>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Steps until the first group is in its places; seconds, negative where that takes more than `most` [s].
double play(World& world, double most) {
    while (world.time() < most) {
        world.step();
        const GroupView group = world.group(0);
        bool there = group.orders.empty();
        for (const std::int32_t i : group.members) {
            const std::int32_t place = world.characters().place[i];
            there = there && place >= 0 &&
                    distance(world.characters().position[i], group.placeTargets[place]) < 0.5;
        }
        if (there) return world.time();
    }
    return -1.0;
}

}  // namespace

TEST_CASE("who finds a door held by another goes through the next, in march and each for itself") {
    for (const Manner manner : {Manner::March, Manner::Free}) {
        CAPTURE(static_cast<int>(manner));
        World world = World::create(twoDoors(Stance::Hold)).value();
        for (int s = 0; s < 30; ++s) world.step();
        Order order = Order::move({9, 0});
        order.manner = manner;
        tell(world, order);
        world.step();
        const double seconds = play(world, 60.0);
        CHECK(seconds > 0.0);
        CHECK(seconds < 20.0);
        CHECK(distance(world.characters().position[8], Vec2{0, 0}) < 0.3);
        for (const std::int32_t i : world.group(0).members) CHECK(world.characters().position[i].x > 5.0);
    }
}

TEST_CASE("who has come into a door after others were on their way through is gone round, too") {
    WorldDef def = twoDoors(Stance::Hold);
    def.groups[0].position = {-15, 0};
    def.groups[1].position = {0, 3};
    def.obstacles[2] = block(-0.5, 4, 0.5, 15);
    def.obstacles[1] = block(-0.5, -7.4, 0.5, 2);
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    tell(world, Order::move({9, 0}));
    CHECK(play(world, 90.0) > 0.0);
}

TEST_CASE(
    "who goes for itself passes a holder on the side on which there is room, not into a pocket at the wall") {
    for (const double gap : {0.1, 2.1}) {
        CAPTURE(gap);
        WorldDef def{.box = {{-25, -12}, {25, 12}}, .obstacles = {block(-6, 2, 6, 6), block(-6, -6, 6, -2)}};
        GroupDef group{.count = 5, .position = {-12, 1.2}};
        def.groups.push_back(group);
        group.count = 1;
        group.position = {0, 2.0 - gap - 0.9};
        group.conduct.stance = Stance::Hold;
        group.bodies = {Body{.radius = 0.9}};
        def.groups.push_back(group);
        World world = World::create(def).value();
        tell(world, Order::go({12, 1.2}));
        world.step();
        CHECK(play(world, 40.0) > 0.0);
        CHECK(world.time() < 16.0);
    }
}

TEST_CASE("two who hold, of different groups, are one to those who cannot come through between them") {
    for (const double gap : {0.1, 0.35}) {
        CAPTURE(gap);
        WorldDef def{.box = {{-20, -12}, {20, 12}}};
        GroupDef group{.count = 6, .position = {-10, 0}};
        def.groups.push_back(group);
        group.count = 1;
        group.conduct.stance = Stance::Hold;
        group.bodies = {Body{.radius = 0.9}};
        // The line from one to the other is oblique to the way.
        for (const double side : {1.0, -1.0}) {
            group.position = {0.2 - 0.2 * side, side * (0.88 + 0.5 * gap)};
            def.groups.push_back(group);
        }
        World world = World::create(def).value();
        tell(world, Order::go({10, 0}));
        world.step();
        CHECK(play(world, 40.0) > 0.0);
        CHECK(world.time() < 15.0);
    }
}

TEST_CASE("four in a door of two hold it: thirty take the next one at once, each for itself") {
    WorldDef def{.box = {{-25, -15}, {25, 15}},
                 .obstacles = {block(-0.3, 1, 0.3, 9), block(-0.3, -15, 0.3, -1), block(-0.3, 11, 0.3, 15)}};
    GroupDef group{.count = 30, .position = {-12, 0}};
    def.groups.push_back(group);
    group.count = 4;
    group.formation.kind = FormationKind::Points;
    group.formation.points = {{0, -0.6}, {0, 0}, {0, 0.6}, {-0.7, 0}};
    group.position = {0, 0};
    group.conduct.stance = Stance::Hold;
    def.groups.push_back(group);
    World world = World::create(def).value();
    tell(world, Order::go({12, 0}));
    world.step();
    CHECK(play(world, 60.0) > 0.0);
    // 31 m at 1.94 m/s and 8 s through the door.
    CHECK(world.time() < 27.0);
}

TEST_CASE("who is idle in a door makes room for all who come, and stands there again") {
    for (const int wait : {0, 30}) {
        CAPTURE(wait);
        World world = World::create(twoDoors(Stance::Normal)).value();
        for (int s = 0; s < wait; ++s) world.step();
        tell(world, Order::move({9, 0}));
        world.step();
        const double seconds = play(world, 60.0);
        CHECK(seconds > 0.0);
        CHECK(seconds < 25.0);
        for (int s = 0; s < 300; ++s) world.step();
        CHECK(distance(world.characters().position[8], Vec2{0, 0}) < 0.5);
    }
}

TEST_CASE("a body four times as wide as ten others goes through among them in a street") {
    WorldDef def{.box = {{-30, -10}, {30, 10}},
                 .obstacles = {block(-12, 2, 12, 10), block(-12, -10, 12, -2)}};
    GroupDef group{.count = 10, .formation = {.files = 2}, .position = {-18, 0}};
    def.groups.push_back(group);
    group.count = 1;
    group.position = {18, 0};
    group.angle = 3.14159265358979;
    group.bodies = {Body{.radius = 1.0, .maxSpeed = 1.5}};
    def.groups.push_back(group);
    World world = World::create(def).value();
    for (std::size_t g = 0; g < 2; ++g) tell(world, Order::move({g == 0 ? 18.0 : -18.0, 0}), g);
    world.step();
    // Alone the small ones take some 20 s, the large one 26 s.
    CHECK(play(world, 60.0) < 32.0);
    while (world.time() < 32.0) world.step();
    CHECK(distance(world.characters().position[10], Vec2{-18, 0}) < 0.5);
}

TEST_CASE("who is ordered into a court where others stand gathers round them within it") {
    WorldDef def{.box = {{-14, -8}, {9, 8}},
                 .obstacles = {block(-0.5, -8, 0, -0.8), block(-0.5, 0.8, 0, 8), block(0, 4, 9, 8),
                               block(0, -8, 9, -4), block(8, -4, 9, 4)}};
    GroupDef group{.count = 16, .position = {-9, 0}};
    def.groups.push_back(group);
    group.position = {4, 0};
    def.groups.push_back(group);
    World world = World::create(def).value();
    tell(world, Order::move({4, 0}));
    world.step();
    CHECK(play(world, 40.0) > 0.0);
    for (const std::int32_t i : world.group(0).members) CHECK(world.characters().position[i].x > 0.0);
}

TEST_CASE("a ring that only just fits stands round a tower; one that does not fit is told so") {
    for (const double spacing : {2.6, 1.6}) {
        CAPTURE(spacing);
        WorldDef def{.box = {{-20, -12}, {12, 12}}, .obstacles = {tree({5, 0}, 2.0)}};
        GroupDef group{.count = 6, .position = {-12, 0}};
        def.groups.push_back(group);
        World world = World::create(def).value();
        Order order = Order::move({5, 0});
        order.formation = FormationDef{};
        order.formation->kind = FormationKind::Ring;
        order.formation->spacing = spacing;
        tell(world, order);
        int done = 0, skipped = 0;
        for (int s = 0; s < 30 * 60; ++s) {
            world.step();
            for (const Event& event : world.events()) {
                done += event.kind == EventKind::OrderDone ? 1 : 0;
                skipped += event.kind == EventKind::OrderSkipped ? 1 : 0;
            }
        }
        CHECK(done == (spacing > 2.0 ? 1 : 0));
        CHECK(skipped == (spacing > 2.0 ? 0 : 1));
        if (done == 0) continue;
        for (const std::int32_t i : world.group(0).members)
            CHECK(std::fabs(distance(world.characters().position[i], Vec2{5, 0}) - 2.6) < 0.3);
    }
}

TEST_CASE("who holds its ground beside a wall stays where it was put") {
    WorldDef def{.box = {{-25, -12}, {25, 12}}, .obstacles = {block(-6, 2, 6, 6), block(-6, -6, 6, -2)}};
    def.groups.push_back(
        {.count = 4,
         .formation = {.kind = FormationKind::Points, .points = {{0, -0.7}, {0, 0}, {0, 0.7}, {-8, 0}}},
         .position = {2, 1.0},
         .conduct = {.stance = Stance::Hold}});
    World world = World::create(def).value();
    const std::vector<Vec2> before(world.characters().position.begin(), world.characters().position.end());
    for (int s = 0; s < 300; ++s) world.step();
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(distance(world.characters().position[i], before[i]) < 0.02);
}
