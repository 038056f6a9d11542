// Marches that flow: they arrive as soon as people on their own would, keep no column on open ground, and are
// restored bit for bit.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/world/scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef street() {
    WorldDef def;
    def.box = {{-40, -30}, {40, 30}};
    def.obstacles = {block(-4, -30, 4, -4), block(-4, 4, 4, 30)};
    GroupDef group;
    group.count = 60;
    group.formation.files = 15;
    group.position = {-25, 3};
    def.groups.push_back(group);
    return def;
}

/// Seconds from an order until it is done; 1e9 for never. `extent` is the greatest extent of the crowd [m].
double playOrder(const WorldDef& def, const Order& order, double& extent) {
    World world = World::create(def).value();
    std::uint32_t sequence = 0;
    for (int s = 0; s < 30; ++s) world.step();
    const double begun = world.time();
    REQUIRE(give(world, sequence, GiveOrder{GroupId{1}, QueueMode::Replace, 0, order}).ok());
    extent = 0.0;
    while (world.time() < begun + 120.0) {
        world.step();
        Box box{world.characters().position[0], world.characters().position[0]};
        for (const Vec2 p : world.characters().position) {
            box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
            box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
        }
        extent = std::max(extent, length(box.max - box.min));
        for (const Event& e : world.events())
            if (e.kind == EventKind::OrderDone) return world.time() - begun;
    }
    return 1e9;
}

WorldDef square(std::int32_t count, std::int32_t files, Vec2 at) {
    WorldDef def;
    def.box = {{-60, -60}, {60, 60}};
    GroupDef group;
    group.count = count;
    group.formation.files = files;
    group.position = at;
    def.groups.push_back(group);
    return def;
}

}  // namespace

TEST_CASE("a line ordered to any side arrives about as soon as a plain walk takes") {
    for (const double angle : {0.0, kPi / 2, kPi, -3 * kPi / 4}) {
        CAPTURE(angle);
        const Vec2 target = Vec2{cosine(angle), sine(angle)} * 40.0;
        double extent = 0.0;
        const double seconds = playOrder(square(60, 60, {0, 0}), Order::move(target), extent);
        // The farthest walks half the line less or more, where it turns by a right angle.
        CHECK(seconds < 1.25 * (40.0 + 30.0 * std::fabs(sine(angle))) / 2.0 + 2.0);
    }
}

TEST_CASE("a line that is to face about turns on the spot") {
    double extent = 0.0;
    CHECK(playOrder(square(60, 30, {0, 0}), Order::face(kPi), extent) < 3.0);
}

TEST_CASE("twenty orders a second to one target do not slow a group") {
    World world = World::create(square(60, 10, {-40, 0})).value();
    std::uint32_t sequence = 0;
    for (int s = 0; s < 20 * 60; ++s) {
        if (s % 3 == 0)
            REQUIRE(give(world, sequence, GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({40, 0})})
                        .ok());
        world.step();
    }
    CHECK(world.group(0).pose.position.x > -5.0);
}

TEST_CASE("a block ordered into a corner of the ground stays a block") {
    double extent = 0.0;
    const double seconds = playOrder(square(100, 10, {30, 30}), Order::move({54, 54}), extent);
    CHECK(seconds < 1.25 * 24.0 * 1.4142 / 2.0 + 2.0);
    CHECK(extent < 1.5 * 9.0 * 1.4142);
}

TEST_CASE("a march that meets a wall on its way, put there later, is planned again and arrives") {
    WorldDef def = square(36, 6, {-30, 0});
    World world = World::create(def).value();
    std::uint32_t sequence = 0;
    world.step();
    REQUIRE(give(world, sequence, GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({30, 0})}).ok());
    for (int s = 0; s < 8 * 60; ++s) world.step();
    REQUIRE(give(world, sequence, AddObstacle{block(0, -12, 2, 12)}).ok());
    bool done = false;
    while (!done && world.time() < 60.0) {
        world.step();
        for (const Event& e : world.events()) done = done || e.kind == EventKind::OrderDone;
    }
    CHECK(done);
    CHECK(world.time() < 50.0);
}

TEST_CASE("a march that flows is restored bit for bit at any step") {
    World world = World::create(street()).value();
    std::uint32_t sequence = 0;
    for (int s = 0; s < 30; ++s) world.step();
    REQUIRE(give(world, sequence, GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({25, -3})}).ok());
    // Copies that go on alone, and when they end: by then they are as the world.
    std::vector<std::pair<World, int>> copies;
    for (int s = 0; s < 240; ++s) {
        CAPTURE(s);
        World copy = World::restore(world.snapshot()).value();
        REQUIRE(copy.hash() == world.hash());
        if (s < 12 || s % 40 == 0) copies.emplace_back(World::restore(world.snapshot()).value(), s + 20);
        world.step();
        copy.step();
        REQUIRE(world.hash() == copy.hash());
        for (auto& [other, end] : copies) {
            if (end <= s) continue;
            other.step();
            if (end == s + 1) REQUIRE(other.hash() == world.hash());
        }
    }
}

TEST_CASE(
    "giants in a formation closer than they are wide march between posts about as fast as on their own") {
    WorldDef def;
    def.box = {{-30, -20}, {30, 20}};
    for (const double y : {-4.8, 0.0, 4.8}) def.obstacles.push_back(block(-0.5, y - 0.5, 0.5, y + 0.5));
    GroupDef group;
    group.count = 5;
    group.formation.files = 5;
    group.position = {-18, 0};
    Body giant;
    giant.radius = 1.1;
    group.bodies = {giant};
    def.groups.push_back(group);
    double extent = 0.0;
    CHECK(playOrder(def, Order::move({18, 0}), extent) < 26.0);
}

TEST_CASE("a block that goes back on the other side of a wall does not fold up") {
    WorldDef def = square(36, 6, {-10, -8});
    def.box = {{-30, -25}, {30, 25}};
    def.obstacles = {block(-30, -0.3, 10, 0.3)};
    double extent = 0.0;
    CHECK(playOrder(def, Order::move({-10, 8}), extent) < 40.0);
}

TEST_CASE("two hundred march through five gates about as fast as on their own, straight on or not") {
    for (const double aside : {0.0, 3.0}) {
        WorldDef def = square(200, 20, {-18, 0});
        def.box = {{-50, -30}, {50, 30}};
        double wall = -30.0;
        for (const double y : {-12.0, -6.0, 0.0, 6.0, 12.0}) {
            def.obstacles.push_back(block(-0.25, wall, 0.25, y - 1.0));
            wall = y + 1.0;
        }
        def.obstacles.push_back(block(-0.25, wall, 0.25, 30.0));
        double extent = 0.0;
        CHECK(playOrder(def, Order::move({18, aside}), extent) < 30.0);
    }
}
