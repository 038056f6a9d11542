// Groups that leave by exits: when each is out, by which exit each goes, and what happens where exits close.
#include <doctest.h>

#include <algorithm>

#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

AreaDef exitAt(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// A hall of 40 m x 10 m whose people leave on the right.
WorldDef hall(std::vector<Vec2> starts) {
    WorldDef def{.box = {{0, 0}, {40, 10}}, .parameters = *parameterPreset("people")};
    def.groups = {{.count = static_cast<std::int32_t>(starts.size()),
                   .position = {10, 5},
                   .starts = std::move(starts),
                   .orders = {Order::leave()}}};
    def.areas = {exitAt(39, 0, 40, 10)};
    return def;
}

std::vector<Vec2> crowd(Box box, double spacing) {
    std::vector<Vec2> starts;
    for (double y = box.min.y; y <= box.max.y; y += spacing)
        for (double x = box.min.x; x <= box.max.x; x += spacing) starts.push_back({x, y});
    return starts;
}

std::int32_t areaEventsOf(const World& world, EventKind kind) {
    return static_cast<std::int32_t>(std::count_if(world.events().begin(), world.events().end(),
                                                   [&](const Event& event) { return event.kind == kind; }));
}

/// Steps until nobody is left; the time, or -1 after so many seconds.
double emptied(World& world, double most) {
    while (world.time() < most) {
        world.step();
        if (world.characters().size() == 0) return world.time();
    }
    return -1.0;
}

}  // namespace

TEST_CASE("one person leaves after the time of its way, and its group ends") {
    World world = World::create(hall({{10, 3}})).value();
    double left = -1.0;
    std::int32_t exited = 0, gone = 0, done = 0, removed = 0;
    for (int s = 0; s < 1800 && left < 0.0; ++s) {
        world.step();
        if (world.characters().size() > 0) {
            CHECK(world.characters().position[0].y == doctest::Approx(3.0).epsilon(1e-6));
            CHECK(world.characters().goal[0] == 1);
            CHECK(world.characters().place[0] == -1);
        }
        exited += areaEventsOf(world, EventKind::Exited);
        gone += areaEventsOf(world, EventKind::Left);
        done += areaEventsOf(world, EventKind::OrderDone);
        removed += areaEventsOf(world, EventKind::GroupRemoved);
        if (world.characters().size() == 0) left = world.time();
    }
    const Parameters::Character& body = world.parameters().character;
    CHECK(left == doctest::Approx(29.0 / body.maxSpeed).epsilon(0.02));
    CHECK(exited == 1);
    CHECK(gone == 1);
    CHECK(done == 1);
    CHECK(removed == 1);
    CHECK(world.groupCount() == 0);
    CHECK(world.area(0).count.passed == 1);
}

TEST_CASE("a crowd in a straight hall walks parallel to the walls over its whole width") {
    WorldDef def = hall(crowd({{2, 1}, {10, 9}}, 1.0));
    World world = World::create(def).value();
    const std::vector<Vec2> before = copyOf(world.characters().position);
    const std::vector<std::uint32_t> ids = copyOf(world.characters().id);
    for (int s = 0; s < 900; ++s) world.step();
    const CharactersView c = world.characters();
    REQUIRE(c.size() == ids.size());
    // Who overtakes goes aside by a lane of 0.46 m or two; nobody goes to the middle or to a wall.
    double drift = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        CHECK(std::fabs(c.position[i].y - before[i].y) < 3.0 * 0.46);
        drift += std::fabs(c.position[i].y - 5.0) - std::fabs(before[i].y - 5.0);
    }
    CHECK(std::fabs(drift) / static_cast<double>(c.size()) < 0.1);
    CHECK(emptied(world, 60.0) > 0.0);
    CHECK(world.area(0).count.passed == ids.size());
}

TEST_CASE("people find their way round walls to a door, and nobody is lost") {
    WorldDef def = hall(crowd({{2, 1}, {8, 9}}, 1.0));
    def.obstacles = {block(15, 0, 15.4, 8), block(25, 2, 25.4, 10)};
    def.areas = {exitAt(39, 0.5, 40, 2)};
    World world = World::create(def).value();
    const auto count = static_cast<std::uint32_t>(world.characters().size());
    CHECK(emptied(world, 120.0) > 0.0);
    CHECK(world.area(0).count.passed == count);
}

TEST_CASE("two exits at equal distances split a crowd evenly") {
    WorldDef def = hall(crowd({{14, 1}, {26, 9}}, 1.0));
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    World world = World::create(def).value();
    CHECK(emptied(world, 120.0) > 0.0);
    const double a = world.area(0).count.passed, b = world.area(1).count.passed;
    CHECK(std::fabs(a - b) < 0.1 * (a + b));
}

TEST_CASE("who goes to an exit that closes goes to another one at once, and hears where there is none") {
    WorldDef def = hall({{30, 5}, {30, 7}});
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    World world = World::create(def).value();
    run(world, 2.0);
    CHECK(world.characters().goal[0] == 2);
    AreaDef closed = world.area(1).def;
    closed.open = false;
    REQUIRE(give(world, putThing(closed, AreaId{2})).ok());
    world.step();
    CHECK(world.characters().goal[0] == 1);
    CHECK(world.characters().direction[0].x < 0.0);
    REQUIRE(give(world, removeThing(AreaId{1})).ok());
    world.step();
    CHECK(areaEventsOf(world, EventKind::NoPath) == 1);
    CHECK(world.characters().goal[0] == 0);
    run(world, 2.0);
    CHECK(length(world.characters().velocity[0]) < 0.01);
    closed.open = true;
    REQUIRE(give(world, putThing(closed, AreaId{2})).ok());
    world.step();
    CHECK(areaEventsOf(world, EventKind::Free) == 1);
    CHECK(emptied(world, 60.0) > 0.0);
    CHECK(world.area(0).count.passed == 2);
}

TEST_CASE("an exit opens and closes at its times") {
    WorldDef def = hall({{30, 5}, {38.9, 5}});
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    def.areas[1].from = 3.0;
    def.areas[1].until = 12.0;
    World world = World::create(def).value();
    run(world, 1.0);
    CHECK(world.characters().goal[0] == 1);
    run(world, 3.5);
    CHECK(world.characters().goal[0] == 2);
    run(world, 7.4);
    CHECK(world.area(1).count.passed == 1);
    run(world, 0.2);
    CHECK(world.characters().goal[0] == 1);
    CHECK(emptied(world, 60.0) > 20.0);
    CHECK(world.area(0).count.passed == 1);
}

TEST_CASE("who leaves disturbs nobody else, and a group that gets places again forms up") {
    WorldDef def = hall(crowd({{20, 1}, {26, 9}}, 1.0));
    def.groups.push_back({.count = 16, .position = {6, 5}});
    World world = World::create(def).value();
    const std::vector<Vec2> before = copyOf(world.group(1).placePositions);
    run(world, 12.0);
    CHECK(world.area(0).count.passed > 10);
    CHECK(world.group(0).placePositions.empty());
    CHECK(std::cmp_equal(world.group(0).members.size(), world.group(0).count));
    CHECK(copyOf(world.group(1).placePositions) == before);
    tell(world, Order::go({20, 5}));
    run(world, 20.0);
    CHECK(std::cmp_equal(world.group(0).placePositions.size(), world.group(0).count));
    CHECK(worstToPlace(world) < 0.6);
    CHECK(world.characters().goal[0] == 0);
}

TEST_CASE("those who follow others choose what most in sight choose") {
    WorldDef def = hall(crowd({{17, 1}, {21, 9}}, 1.0));
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    def.groups[0].orders[0].choice = ExitChoice::Nearest;
    const auto byLeft = [&](double herding) {
        def.groups[0].orders[0].herding = herding;
        World world = World::create(def).value();
        run(world, 3.0);
        const CharactersView c = world.characters();
        return std::count(c.goal.begin(), c.goal.end(), 1u);
    };
    const auto count = static_cast<std::ptrdiff_t>(def.groups[0].starts.size());
    CHECK(byLeft(0.0) > 0);
    CHECK(byLeft(0.0) < count);
    CHECK(byLeft(30.0) == count);
}

TEST_CASE("who misjudges the time takes another exit now and then, the same in every run") {
    WorldDef def = hall(crowd({{10, 1}, {14, 9}}, 1.0));
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    def.groups[0].orders[0].choice = ExitChoice::Nearest;
    const auto goals = [&](double misjudgement, std::uint64_t seed) {
        def.seed = seed;
        def.groups[0].orders[0].misjudgement = misjudgement;
        World world = World::create(def).value();
        run(world, 2.0);
        return copyOf(world.characters().goal);
    };
    const auto none = goals(0.0, 1), some = goals(8.0, 1);
    CHECK(std::count(none.begin(), none.end(), 2u) == 0);
    CHECK(std::count(some.begin(), some.end(), 2u) > 0);
    CHECK(some == goals(8.0, 1));
    CHECK(some != goals(8.0, 2));
}

TEST_CASE("an attraction counts as time, and groups that are assigned exits keep to them") {
    WorldDef def = hall(crowd({{10, 1}, {14, 9}}, 1.0));
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    def.groups[0].orders[0] = Order::leave({AreaId{1}, AreaId{2}});
    def.groups[0].orders[0].attractions = {0.0, 100.0};
    World drawn = World::create(def).value();
    run(drawn, 2.0);
    const CharactersView c = drawn.characters();
    CHECK(std::cmp_equal(std::count(c.goal.begin(), c.goal.end(), 2u), c.size()));
    def.groups[0].orders[0] = Order::leave({AreaId{2}});
    World assigned = World::create(def).value();
    CHECK(emptied(assigned, 120.0) > 0.0);
    CHECK(assigned.area(0).count.passed == 0);
}

TEST_CASE("a near exit is preferred, and a far one is used where many wait") {
    WorldDef def = hall(crowd({{3, 1}, {12, 9}}, 0.6));
    def.obstacles = {block(2, 0, 2.4, 4.5), block(2, 5.5, 2.4, 10), block(37, 0, 37.4, 4.5),
                     block(37, 5.5, 37.4, 10)};
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    World world = World::create(def).value();
    double last[2] = {};
    while (world.time() < 200.0 && world.characters().size() > 0) {
        world.step();
        for (const Event& event : world.events())
            if (event.kind == EventKind::Exited) last[event.value - 1] = world.time();
    }
    REQUIRE(world.characters().size() == 0);
    CHECK(world.area(0).count.passed > world.area(1).count.passed);
    CHECK(world.area(1).count.passed > 40);
    CHECK(std::fabs(last[0] - last[1]) < 0.15 * std::max(last[0], last[1]));
}

TEST_CASE("nothing is allocated while people walk to exits, and the outcome is the same with any threads") {
    WorldDef def = hall(crowd({{3, 1}, {12, 9}}, 0.8));
    def.areas = {exitAt(0, 4, 1, 6), exitAt(39, 4, 40, 6)};
    World one = World::create(def, 1).value(), many = World::create(def, 4).value();
    for (int s = 0; s < 600; ++s) {
        one.step();
        many.step();
        if (s % 50 == 0) REQUIRE(one.hash() == many.hash());
    }
    REQUIRE(one.hash() == many.hash());
}

TEST_CASE("a thin wall before an exit is gone round, and an exit thinner than a cell is found") {
    WorldDef def = hall(crowd({{10, 2}, {14, 8}}, 1.0));
    def.obstacles = {block(20, 0, 20.05, 8.8)};
    def.areas = {exitAt(20.3, 1, 20.38, 8)};
    World world = World::create(def).value();
    const auto count = static_cast<std::uint32_t>(world.characters().size());
    for (int s = 0; s < 3600 && world.characters().size() > 0; ++s) {
        const std::vector<Vec2> before = copyOf(world.characters().position);
        const std::vector<std::uint32_t> ids = copyOf(world.characters().id);
        world.step();
        const CharactersView c = world.characters();
        for (std::size_t i = 0; i < c.size(); ++i) {
            const auto k = std::find(ids.begin(), ids.end(), c.id[i]) - ids.begin();
            if (before[k].x < 20.0 && c.position[i].x >= 20.0) CHECK(c.position[i].y > 8.7);
        }
    }
    CHECK(world.area(0).count.passed == count);
}
