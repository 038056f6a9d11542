// Marches that flow: they arrive as soon as people on their own would, keep no column on open ground, and are
// restored bit for bit.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef street() {
    return {.box = {{-40, -30}, {40, 30}},
            .obstacles = {block(-4, -30, 4, -4), block(-4, 4, 4, 30)},
            .groups = {{.count = 60, .formation = {.files = 15}, .position = {-25, 3}}}};
}

/// Seconds from an order until it is done; 1e9 for never. `extent` is the greatest extent of the crowd [m].
double playOrder(const WorldDef& def, const Order& order, double& extent) {
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    const double begun = world.time();
    tell(world, order, GroupId{1});
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
    return {.box = {{-60, -60}, {60, 60}},
            .groups = {{.count = count, .formation = {.files = files}, .position = at}}};
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

TEST_CASE("a march that is ordered exchanges nobody on open ground, however often") {
    World world = World::create(square(60, 10, {0, 0})).value();
    std::int32_t swaps = 0;
    for (int s = 0; s < 20 * 60; ++s) {
        const double angle = 0.7 * s;
        if (s % 6 == 0) tell(world, Order::move({3.0 * cosine(angle), 3.0 * sine(angle)}), GroupId{1});
        world.step();
        for (const Event& e : world.events()) swaps += e.kind == EventKind::Swap ? 1 : 0;
    }
    CHECK(swaps <= 60);
}

TEST_CASE("orders to where nobody can come move a group once, for each that is free too") {
    for (const Manner manner : {Manner::March, Manner::Free}) {
        WorldDef def = square(60, 10, {0, 0});
        def.obstacles = {block(-8, -8, -7, 8), block(7, -8, 8, 8), block(-7, -8, 7, -7), block(-7, 7, 7, 8)};
        World world = World::create(def).value();
        std::uint32_t told = 0;
        std::vector<double> walked(60, 0.0);
        for (int s = 0; s < 20 * 60; ++s) {
            Order order = Order::move({-50.0, 15.0 * sine(0.3 * s)});
            order.manner = manner;
            if (s % 6 == 0) tell(world, order, GroupId{1});
            const std::vector<Vec2> before = copyOf(world.characters().position);
            world.step();
            for (const Event& e : world.events()) told += e.kind == EventKind::NoPath ? 1 : 0;
            for (std::size_t i = 0; i < walked.size(); ++i)
                walked[i] += distance(before[i], world.characters().position[i]);
        }
        CAPTURE(static_cast<int>(manner));
        CHECK(told == 200);
        CHECK(*std::max_element(walked.begin(), walked.end()) < 16.0);
    }
}

TEST_CASE("twenty orders a second to one target do not slow a group") {
    World world = World::create(square(60, 10, {-40, 0})).value();
    for (int s = 0; s < 20 * 60; ++s) {
        if (s % 3 == 0) tell(world, Order::move({40, 0}), GroupId{1});
        world.step();
    }
    CHECK(world.group(0).pose.position.x > -5.0);
}

TEST_CASE("a block goes through a winding street narrower than itself, however often it is ordered") {
    WorldDef def{
        .box = {{-40, -30}, {50, 30}},
        .obstacles = {block(-6.15, 1.2, 4.8, 1.5), block(4.5, 1.2, 4.8, 11.5), block(4.5, 11.2, 20.15, 11.5),
                      block(-6.15, -1.5, 7.5, -1.2), block(7.2, -1.5, 7.5, 8.8), block(7.2, 8.5, 20.15, 8.8),
                      block(-6.15, 1.25, -5.85, 28.15), block(-6.15, -28.15, -5.85, -1.25)}};
    def.groups.push_back({.count = 30, .position = {-14, 0}});
    // Once, every second and every 0.3 s; round the walls it is 83 m instead of 53.
    for (const std::uint32_t every : {10000u, 60u, 18u}) {
        CAPTURE(every);
        World world = World::create(def).value();
        bool done = false;
        while (!done && world.time() < 80.0) {
            const double off = world.stepCount() % 36 == 0 ? 0.1 : 0.0;
            if (world.stepCount() % every == 0 && world.time() < 19.0)
                tell(world, Order::move({28 + off, 10}), GroupId{1});
            world.step();
            for (const Event& e : world.events()) done = done || e.kind == EventKind::OrderDone;
        }
        CHECK(world.time() < 38.0);
    }
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
    world.step();
    tell(world, Order::move({30, 0}), GroupId{1});
    for (int s = 0; s < 8 * 60; ++s) world.step();
    REQUIRE(give(world, putThing(block(0, -12, 2, 12))).ok());
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
    for (int s = 0; s < 30; ++s) world.step();
    tell(world, Order::move({25, -3}), GroupId{1});
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
    "eight groups ordered to one point from all sides come to rest round it without waiting for each other") {
    WorldDef def = square(25, 5, {});
    for (int k = 0; k < 8; ++k) {
        if (k > 0) def.groups.push_back(def.groups[0]);
        const double angle = 0.25 * kPi * k;
        def.groups[k].position = {40.0 * cosine(angle), 40.0 * sine(angle)};
        def.groups[k].angle = angle + kPi;
    }
    World world = World::create(def).value();
    std::uint32_t done = 0;
    for (std::uint32_t k = 0; k < 8; ++k) tell(world, Order::move({0, 0}), GroupId{k + 1});
    while (world.time() < 26.0) {  // 20 s alone.
        world.step();
        for (const Event& e : world.events()) done += e.kind == EventKind::OrderDone ? 1 : 0;
    }
    CHECK(done == 8);
    for (const Vec2 v : world.characters().velocity) CHECK(length(v) < 0.05);
}

TEST_CASE("an order to go each for itself among thin walls exchanges few") {
    WorldDef def = square(20, 5, {-6, 0});
    def.box = {{-15, -15}, {15, 15}};
    // Rooms with doors of 0.9 m.
    for (const double y : {-6.0, 0.0, 6.0}) {
        def.obstacles.push_back(block(0, y + 0.45, 0.1, y + 5.55));
        def.obstacles.push_back(block(0.1, y + 2.9, 6, y + 3.0));
    }
    def.obstacles.push_back(block(0, -15, 0.1, -6.45));
    def.obstacles.push_back(block(0, 11.55, 0.1, 15));
    World world = World::create(def).value();
    std::uint32_t swaps = 0;
    tell(world, Order::go({10, 2}), GroupId{1});
    while (world.time() < 40.0) {
        world.step();
        for (const Event& e : world.events()) swaps += e.kind == EventKind::Swap ? 1 : 0;
    }
    CHECK(swaps <= 80);
    for (const Vec2 p : world.characters().position) CHECK(distance(p, {10, 2}) < 4.5);
}

TEST_CASE(
    "giants in a formation closer than they are wide march between posts about as fast as on their own") {
    WorldDef def{.box = {{-30, -20}, {30, 20}}};
    for (const double y : {-4.8, 0.0, 4.8}) def.obstacles.push_back(block(-0.5, y - 0.5, 0.5, y + 0.5));
    def.groups.push_back(
        {.count = 5, .formation = {.files = 5}, .position = {-18, 0}, .bodies = {{.radius = 1.1}}});
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

TEST_CASE("a march through a door takes about as long as each for itself") {
    struct Case {
        std::int32_t count, files;
        double spacing, from, width, bound;
    };
    // In a room of 12 m that they fill; close before a wall; from afar.
    for (const Case& c : {Case{150, 13, 0.85, 0.0, 1.2, 1.15}, Case{100, 10, 1.0, 1.0, 2.0, 1.2},
                          Case{60, 8, 1.0, -9.0, 1.0, 1.2}}) {
        double seconds[2] = {};
        for (const Manner manner : {Manner::Free, Manner::March}) {
            WorldDef def{.box = {{-30, -20}, {60, 20}},
                         .obstacles = {block(6, 0.5 * c.width, 6.3, 20), block(6, -20, 6.3, -0.5 * c.width)}};
            if (c.count == 150)
                def.obstacles.insert(def.obstacles.end(), {block(-6.3, -6.3, -6, 6.3), block(-6, 6, 6, 6.3),
                                                           block(-6, -6.3, 6, -6)});
            GroupDef group{.count = c.count,
                           .formation = {.spacing = c.spacing, .files = c.files},
                           .position = {c.from, 0}};
            def.groups.push_back(group);
            World world = World::create(def).value();
            Order order = Order::move({25, 0});
            order.manner = manner;
            tell(world, order);
            world.step();
            while (!world.group(0).orders.empty() && world.time() < 100.0) world.step();
            seconds[manner == Manner::March ? 1 : 0] = world.time();
            CHECK(world.contacts().overlapPairs == 0);
        }
        CAPTURE(seconds[0]);
        CAPTURE(seconds[1]);
        CHECK(seconds[1] < c.bound * seconds[0]);
    }
}

TEST_CASE("points of a formation that are far enough apart stay as they are, whatever its spacing says") {
    WorldDef def{.box = {{-30, -20}, {40, 20}}};
    GroupDef group{
        .count = 4,
        .formation = {.kind = FormationKind::Points, .points = {{0, 0}, {-2.6, 0}, {-5.2, 0}, {-7.8, 0}}},
        .bodies = {Body{.radius = 1.0}}};
    def.groups.push_back(group);
    World world = World::create(def).value();
    for (const Manner manner : {Manner::March, Manner::Free}) {
        Order order = Order::move({manner == Manner::March ? 15.0 : 25.0, 0});
        order.manner = manner;
        tell(world, order);
        run(world, 25.0);
        double least = 1e9, most = -1e9;
        for (const Vec2 p : world.characters().position) {
            least = std::min(least, p.x);
            most = std::max(most, p.x);
        }
        CHECK(most - least == doctest::Approx(7.8).epsilon(0.05));
    }
}

TEST_CASE("who is ordered to where it stands already does not turn about") {
    for (const Manner manner : {Manner::March, Manner::Free}) {
        WorldDef def{.box = {{-20, -20}, {20, 20}}, .obstacles = {block(4, -20, 4.3, 0)}};
        GroupDef group{.count = 36, .position = {-4, 0}};
        def.groups.push_back(group);
        World world = World::create(def).value();
        run(world, 2.0);
        const auto before = copyOf(world.characters().position);
        for (int k = 0; k < 6; ++k) {
            Vec2 middle;
            for (const Vec2 p : world.characters().position) middle += p / 36.0;
            Order order = Order::move(middle + Vec2{0.01, -0.02});
            order.manner = manner;
            tell(world, order);
            run(world, 0.5);
        }
        for (std::size_t i = 0; i < before.size(); ++i)
            CHECK(distance(before[i], world.characters().position[i]) < 0.5);
    }
}
