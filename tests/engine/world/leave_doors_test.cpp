// People who leave and have the choice between doors: who goes by which, when all are out, and how often they
// change their minds.
#include <doctest.h>

#include <algorithm>
#include <map>

#include "counting_new.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kWallAt = 15.0;

AreaDef leaveArea(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

std::vector<Vec2> gridOf(Box box, std::size_t columns, std::size_t rows) {
    std::vector<Vec2> starts;
    const Vec2 size = box.max - box.min;
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x)
            starts.push_back(box.min + Vec2{size.x * (static_cast<double>(x) + 0.5) / columns,
                                            size.y * (static_cast<double>(y) + 0.5) / rows});
    return starts;
}

GroupDef leaversAt(std::vector<Vec2> starts) {
    GroupDef group{.count = static_cast<std::int32_t>(starts.size()), .starts = std::move(starts)};
    group.position = group.starts.front();
    group.orders = {Order::leave()};
    return group;
}

/// Two halls and a wall between them with a door at y = 3, and one at y = 11 unless it is shut. The exit is
/// near the first.
WorldDef twoHalls(std::vector<Vec2> starts, bool hasFarDoor = true) {
    WorldDef def{.box = {{0, 0}, {30, 16}},
                 .obstacles = {block(kWallAt, 0, kWallAt + 0.2, 3), block(kWallAt, 4, kWallAt + 0.2, 11),
                               block(kWallAt, 12, kWallAt + 0.2, 16)},
                 .parameters = *parameterPreset("people")};
    if (!hasFarDoor) def.obstacles.push_back(block(kWallAt, 11, kWallAt + 0.2, 12));
    def.groups = {leaversAt(std::move(starts))};
    def.areas = {leaveArea(28, 2, 29.5, 5)};
    return def;
}

/// What a run of twoHalls() has come to.
struct Left {
    double after = -1.0;  // When all are out [s].
    std::int32_t near = 0, far = 0;
    std::int32_t mostTurns = 0, turns = 0;  // Changes of mind before the wall: of one, and of all.
};

Left runHalls(World& world, double most) {
    Left left;
    std::map<std::uint32_t, Vec2> before;
    std::map<std::uint32_t, std::int32_t> way, turns;
    while (world.time() < most && left.after < 0.0) {
        world.step();
        const CharactersView c = world.characters();
        for (std::size_t i = 0; i < c.size(); ++i) {
            const std::uint32_t id = c.id[i];
            const Vec2 p = c.position[i];
            if (p.x < kWallAt) {
                const std::int32_t now = inspect::doorWay(world, i);
                if (way.contains(id) && way[id] != now) ++turns[id];
                way[id] = now;
            }
            if (before.contains(id) && before[id].x < kWallAt && p.x >= kWallAt)
                ++(p.y < 8.0 ? left.near : left.far);
            before[id] = p;
        }
        if (c.size() == 0) left.after = world.time();
    }
    for (const auto& [id, count] : turns) {
        left.turns += count;
        left.mostTurns = std::max(left.mostTurns, count);
    }
    return left;
}

}  // namespace

TEST_CASE("people who leave by one exit share two doors by time, and hardly change their minds") {
    const std::vector<Vec2> starts = gridOf({{2, 1}, {11, 7}}, 15, 10);
    World one = World::create(twoHalls(starts, false)).value();
    const Left byNear = runHalls(one, 200.0);
    CHECK(byNear.near == 150);
    CHECK(byNear.turns == 0);
    World both = World::create(twoHalls(starts)).value();
    const Left left = runHalls(both, 200.0);
    CHECK(left.near > 60);
    CHECK(left.far > 50);
    CHECK(left.near > left.far);
    CHECK(left.after > 0.0);
    CHECK(left.after < 0.7 * byNear.after);
    CHECK(left.mostTurns <= 3);
    CHECK(left.turns < 150);
    MESSAGE("by two doors " << left.after << " s, by one " << byNear.after << " s; changes of mind "
                            << left.turns << ", of one " << left.mostTurns);
}

TEST_CASE("doors count in walls so thin that no centre of a cell lies in them") {
    for (const double thin : {0.2, 0.06}) {
        WorldDef def = twoHalls(gridOf({{2, 1}, {11, 7}}, 15, 10));
        const double x0 = kWallAt - 0.5 * thin, x1 = kWallAt + 0.5 * thin;
        def.obstacles = {block(x0, 0, x1, 3), block(x0, 4, x1, 11), block(x0, 12, x1, 16)};
        World world = World::create(def).value();
        const Left left = runHalls(world, 200.0);
        CHECK(left.after > 0.0);
        CHECK(left.near > 60);
        CHECK(left.far > 50);
        CHECK(left.mostTurns <= 3);
    }
}

TEST_CASE("two exits a walk behind their doors share a crowd that is before one of them") {
    for (const bool parted : {false, true}) {
        WorldDef def = twoHalls(gridOf({{2, 1}, {11, 7}}, 15, 10));
        if (parted) def.obstacles.push_back(block(kWallAt + 0.2, 7.4, 30, 7.6));
        const double x = parted ? 18.2 : 28.5;
        def.areas = {leaveArea(x, 0.2, x + 1.0, 7.2), leaveArea(x, 7.8, x + 1.0, 15.8)};
        World world = World::create(def).value();
        const Left left = runHalls(world, 200.0);
        CHECK(left.after > 0.0);
        CHECK(left.near > 55);
        CHECK(left.far > 55);
    }
}

TEST_CASE("customers of two slow tills hardly change their minds") {
    for (const bool hasLine : {true, false}) {
        WorldDef def{.box = {{0, 0}, {20, 17}},
                     .groups = {leaversAt(gridOf({{2, 7}, {18, 16}}, 8, 5))},
                     .parameters = *parameterPreset("people")};
        PeopleDef people{.premovement = Distribution::uniform(0.0, 60.0)};
        def.groups[0].people = {people};
        for (const double x : {6.0, 14.0}) {
            AreaDef till = leaveArea(x - 0.5, 0.5, x + 0.5, 1.5);
            till.rate = 0.2;
            if (hasLine) till.queue = {{x, 2}, {x, 6}};
            def.areas.push_back(till);
        }
        World world = World::create(def).value();
        std::map<std::uint32_t, std::uint32_t> goal;
        std::map<std::uint32_t, Vec2> start;
        std::map<std::uint32_t, std::int32_t> turns;
        while (world.time() < 130.0) {
            world.step();
            const CharactersView c = world.characters();
            for (std::size_t i = 0; i < c.size(); ++i) {
                const std::uint32_t id = c.id[i];
                // Who has not set out may choose again.
                const bool isOnFoot = distance(start.try_emplace(id, c.position[i]).first->second,
                                               c.position[i]) > 0.2;
                if (isOnFoot && goal[id] != c.goal[i]) ++turns[id];
                goal[id] = c.goal[i];
            }
        }
        CHECK(world.characters().size() == 0);
        std::int32_t all = 0;
        for (const auto& [id, count] : turns) {
            CHECK(count <= 3);
            all += count;
        }
        CHECK(all <= 20);
        MESSAGE("changes of till on foot " << all);
    }
}

TEST_CASE("who does not have to wait takes the near door") {
    World world = World::create(twoHalls({{5, 4}, {4, 6}, {8, 2}})).value();
    const Left left = runHalls(world, 60.0);
    CHECK(left.near == 3);
    CHECK(left.turns == 0);
}

TEST_CASE("with the nearest exit ordered, people take the near door") {
    WorldDef def = twoHalls(gridOf({{2, 1}, {11, 7}}, 9, 6));
    def.groups[0].orders[0].choice = ExitChoice::Nearest;
    World world = World::create(def).value();
    const Left left = runHalls(world, 120.0);
    CHECK(left.near == 54);
    CHECK(left.far == 0);
}

TEST_CASE("a long exit just behind two doors is left to by both") {
    WorldDef def = twoHalls(gridOf({{2, 1}, {11, 7}}, 12, 8));
    def.box.max.x = 17;
    def.areas = {leaveArea(16, 0.2, 16.8, 15.8)};
    World world = World::create(def).value();
    const Left left = runHalls(world, 120.0);
    CHECK(left.after > 0.0);
    CHECK(left.far > 30);
    CHECK(left.near >= left.far);
}

TEST_CASE("people before a slow door do not go round at a fast one behind it") {
    WorldDef def = twoHalls(gridOf({{1, 1}, {7, 7}}, 10, 10));
    def.obstacles.push_back(block(8, 0, 8.2, 3));
    def.obstacles.push_back(block(8, 4, 8.2, 16));
    World world = World::create(def).value();
    const Left left = runHalls(world, 200.0);
    CHECK(left.after > 0.0);
    CHECK(left.far < 10);
}

TEST_CASE("when a door shuts, those before it go by the other one, and come back when it opens") {
    World world = World::create(twoHalls(gridOf({{2, 1}, {11, 7}}, 15, 10))).value();
    run(world, 15.0);
    REQUIRE(give(world, putThing(block(kWallAt, 11, kWallAt + 0.2, 12))).ok());
    world.step();
    for (std::size_t i = 0; i < world.characters().size(); ++i) CHECK(inspect::doorWay(world, i) == -1);
    CHECK(runHalls(world, 200.0).after > 0.0);
}

TEST_CASE("a door that a moving obstacle fills counts as shut") {
    WorldDef def = twoHalls(gridOf({{2, 1}, {11, 7}}, 8, 8));
    ObstacleDef gate = block(kWallAt, 3, kWallAt + 0.2, 4);
    gate.path.waypoints = {{0.0, {0, 0}, 0.0}, {200.0, {0, 0}, 0.0}, {202.0, {0, -1.1}, 0.0}};
    def.obstacles.push_back(gate);
    World world = World::create(def).value();
    const Left left = runHalls(world, 150.0);
    CHECK(left.after > 0.0);
    CHECK(left.far == 64);
}

TEST_CASE("a choice of doors goes on alike after loading, and for any number of threads") {
    WorldDef def = twoHalls(gridOf({{2, 1}, {11, 7}}, 12, 8));
    World world = World::create(def).value();
    World other = World::create(def, 3).value();
    for (int k = 0; k < 8; ++k) {
        run(world, 2.0 + 0.05 * k);
        run(other, 2.0 + 0.05 * k);
        REQUIRE(world.hash() == other.hash());
        World loaded = World::restore(world.snapshot()).value();
        run(loaded, 1.0);
        run(world, 1.0);
        run(other, 1.0);
        REQUIRE(loaded.hash() == world.hash());
    }
}

TEST_CASE("60 steps of people who choose between doors allocate nothing") {
    World world = World::create(twoHalls(gridOf({{2, 1}, {11, 7}}, 12, 8))).value();
    run(world, 4.0);
    const long before = allocations;
    run(world, 1.0);
    // Some have come out.
    CHECK(allocations - before == 0);
}
