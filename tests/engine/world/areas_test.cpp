// Sources, exits with a rate or a line, waiting areas, and walking on.
#include <doctest.h>

#include <algorithm>
#include <map>

#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

AreaDef areaOf(AreaKind kind, double x0, double y0, double x1, double y1) {
    return {.kind = kind, .polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// A floor of 40 m x 20 m for people, with one group of `count` that carries out orders.
WorldDef floorFor(std::int32_t count, std::vector<Order> orders) {
    WorldDef def{.box = {{0, 0}, {40, 20}}, .parameters = *parameterPreset("people")};
    def.groups = {{.count = count, .position = {10, 10}, .orders = std::move(orders)}};
    return def;
}

double closestBodies(const World& world) {
    const CharactersView c = world.characters();
    double least = 1e9;
    for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(c.position[i], c.position[j]));
    return least - 2.0 * world.parameters().character.radius;
}

int eventsOf(const World& world, EventKind kind) {
    return static_cast<int>(std::count_if(world.events().begin(), world.events().end(),
                                          [&](const Event& event) { return event.kind == kind; }));
}

double fastestWalker(const World& world) {
    double most = 0.0;
    for (const Vec2 v : world.characters().velocity) most = std::max(most, length(v));
    return most;
}

}  // namespace

TEST_CASE("a source sends people at its rate, who join its group, leave, and nobody overlaps") {
    WorldDef def = floorFor(0, {Order::leave()});
    AreaDef source = areaOf(AreaKind::Source, 1, 8, 4, 12);
    source.rate = 2.0;
    source.most = 120;
    def.areas = {source, areaOf(AreaKind::Exit, 39, 8, 40, 12)};
    World world = World::create(def).value();
    CHECK(world.groupCount() == 1);
    CHECK(world.group(0).count == 0);
    int entered = 0, joined = 0, exited = 0;
    double half = 0.0;
    while (world.time() < 150.0 && (entered < 120 || world.characters().size() > 0)) {
        world.step();
        entered += eventsOf(world, EventKind::Entered);
        joined += eventsOf(world, EventKind::Joined);
        exited += eventsOf(world, EventKind::Exited);
        if (half == 0.0 && entered >= 60) half = world.time();
        if (world.stepCount() % 60 == 0) CHECK(closestBodies(world) > -0.05);
    }
    CHECK(entered == 120);
    CHECK(joined == 120);
    CHECK(exited == 120);
    CHECK(world.area(0).count.passed == 120);
    CHECK(world.groupCount() == 0);
    // 60 arrivals of a Poisson process of 2 a second: a mean of 30 s, deviation 3.9 s.
    CHECK(half == doctest::Approx(30.0).epsilon(0.4));
}

TEST_CASE("a timetable sends so many at its times, and who finds no room waits") {
    WorldDef def = floorFor(0, {Order::leave()});
    AreaDef source = areaOf(AreaKind::Source, 1, 9, 2, 10);
    source.timetable = {{1.0, 3}, {5.0, 20}};
    def.areas = {source, areaOf(AreaKind::Exit, 39, 8, 40, 12)};
    World world = World::create(def).value();
    run(world, 0.9);
    CHECK(world.characters().size() == 0);
    run(world, 3.0);
    CHECK(world.area(0).count.passed == 3);
    run(world, 1.2);
    CHECK(world.area(0).count.waiting > 0);
    CHECK(world.area(0).count.passed + world.area(0).count.waiting == 23);
    run(world, 60.0);
    CHECK(world.area(0).count.passed == 23);
    CHECK(world.groupCount() == 0);
}

TEST_CASE("people of a source take places in a group that has some") {
    WorldDef def = floorFor(0, {Order::go({20, 10})});
    AreaDef source = areaOf(AreaKind::Source, 1, 8, 4, 12);
    source.timetable = {{0.5, 9}};
    def.areas = {source};
    World world = World::create(def).value();
    run(world, 40.0);
    REQUIRE(world.characters().size() == 9);
    CHECK(world.group(0).placePositions.size() == 9);
    CHECK(worstToPlace(world) < 0.6);
}

TEST_CASE("an exit lets out at its rate exactly, in the order in which people came") {
    WorldDef def = floorFor(64, {Order::leave()});
    AreaDef exit = areaOf(AreaKind::Exit, 38, 6, 40, 14);
    exit.rate = 0.5;
    def.areas = {exit};
    World world = World::create(def).value();
    std::vector<double> times;
    while (world.time() < 90.0) {
        world.step();
        for (int k = 0; k < eventsOf(world, EventKind::Exited); ++k) times.push_back(world.time());
    }
    REQUIRE(times.size() > 20);
    for (std::size_t k = 1; k < times.size(); ++k) {
        CAPTURE(k);
        CHECK(times[k] - times[k - 1] == doctest::Approx(2.0).epsilon(0.01));
    }
}

TEST_CASE("people stand in line before an exit, as far apart as their bodies, and are served in turn") {
    WorldDef def = floorFor(30, {Order::leave()});
    AreaDef exit = areaOf(AreaKind::Exit, 38, 9, 39, 11);
    exit.rate = 0.4;
    exit.queue = {{37, 10}, {25, 10}};
    def.areas = {exit};
    World world = World::create(def).value();
    run(world, 45.0);
    int inLine = 0;
    for (const Vec2 p : world.characters().position)
        inLine += std::fabs(p.y - 10.0) < 0.2 && p.x > 25.0 ? 1 : 0;
    CHECK(inLine > 10);
    CHECK(closestBodies(world) > 0.0);
    run(world, 70.0);
    CHECK(world.characters().size() == 0);
}

TEST_CASE("a group waits in an area for its time, spread over it, and goes on") {
    Order wait = Order::wait(AreaId{1}, 10.0);
    wait.share = 1.0;
    WorldDef def = floorFor(25, {wait, Order::leave()});
    def.areas = {areaOf(AreaKind::Waiting, 24, 6, 32, 14), areaOf(AreaKind::Exit, 39, 8, 40, 12)};
    World world = World::create(def).value();
    run(world, 28.0);
    int inside = 0;
    for (const Vec2 p : world.characters().position)
        inside += p.x > 23.9 && p.x < 32.1 && p.y > 5.9 && p.y < 14.1;
    CHECK(inside == 25);
    CHECK(closestBodies(world) > 0.1);
    CHECK(fastestWalker(world) < 0.05);
    double done = 0.0;
    while (world.time() < 60.0 && world.characters().size() > 0) {
        world.step();
        if (done == 0.0 && eventsOf(world, EventKind::OrderDone) > 0) done = world.time();
    }
    CHECK(done > 28.0);
    CHECK(world.characters().size() == 0);
}

TEST_CASE("who does not fit into a waiting area stands before it") {
    Order wait = Order::wait(AreaId{1}, 5.0);
    WorldDef def = floorFor(40, {wait, Order::leave()});
    def.areas = {areaOf(AreaKind::Waiting, 28, 9, 30, 11), areaOf(AreaKind::Exit, 39, 8, 40, 12)};
    World world = World::create(def).value();
    run(world, 24.0);
    CHECK(closestBodies(world) > -0.05);
    run(world, 60.0);
    CHECK(world.characters().size() == 0);
}

TEST_CASE("groups share the spots of a waiting area, whoever comes first") {
    for (const bool later : {false, true}) {
        CAPTURE(later);
        WorldDef def = floorFor(15, {Order::wait(AreaId{1})});
        def.areas = {areaOf(AreaKind::Waiting, 18, 7, 22, 13), areaOf(AreaKind::Waiting, 1, 1, 4, 4)};
        GroupDef other = def.groups[0];
        other.position = {30, 10};
        if (later) other.orders.clear();
        def.groups.push_back(other);
        World world = World::create(def).value();
        run(world, 20.0);
        const Order wait = Order::wait(AreaId{1});
        if (later)
            REQUIRE(
                world.submit({world.stepCount(), 1, 0, GiveOrder{GroupId{2}, QueueMode::Replace, 0, wait}})
                    .ok());
        run(world, 30.0);
        int inside = 0;
        for (const Vec2 p : world.characters().position)
            inside += p.x > 17.9 && p.x < 22.1 && p.y > 6.9 && p.y < 13.1;
        CHECK(inside == 30);
        CHECK(closestBodies(world) > 0.05);
        CHECK(fastestWalker(world) < 0.05);
    }
}

TEST_CASE("a waiting area takes as many as have room in it") {
    WorldDef def = floorFor(60, {Order::wait(AreaId{1})});
    def.areas = {areaOf(AreaKind::Waiting, 18, 7, 22, 13)};
    World world = World::create(def).value();
    run(world, 60.0);
    int inside = 0;
    for (const Vec2 p : world.characters().position)
        inside += p.x > 17.9 && p.x < 22.1 && p.y > 6.9 && p.y < 13.1;
    CHECK(inside == 60);
}

TEST_CASE("people walk on towards a heading round obstacles, and stand at the far side") {
    WorldDef def = floorFor(16, {Order::walk(0.0)});
    def.obstacles = {block(20, 7, 22, 13)};
    World world = World::create(def).value();
    run(world, 45.0);
    for (const Vec2 p : world.characters().position) CHECK(p.x > 36.0);
    const WorldDef open = floorFor(16, {Order::walk(0.0)});
    World straight = World::create(open).value();
    const std::vector<Vec2> before = copyOf(straight.characters().position);
    run(straight, 10.0);
    // Who overtakes goes aside; all of them keep the heading.
    double drift = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double aside = straight.characters().position[i].y - before[i].y;
        CHECK(std::fabs(aside) < 2.0);
        drift += aside / static_cast<double>(before.size());
    }
    CHECK(std::fabs(drift) < 0.1);
}
