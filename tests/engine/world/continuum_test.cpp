// Orders that are carried out by one continuum field: nobody has a place, all go to one point.
#include <doctest.h>

#include <algorithm>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

Order gatherAt(Vec2 target) {
    Order order = Order::move(target);
    order.manner = Manner::Continuum;
    return order;
}

double farthest(const World& world, Vec2 from, std::size_t group = 0) {
    double most = 0.0;
    const GroupView view = world.group(group);
    for (const std::int32_t i : view.members)
        most = std::max(most, distance(world.characters().position[i], from));
    return most;
}

double fastest(const World& world) {
    double most = 0.0;
    for (const Vec2 v : world.characters().velocity) most = std::max(most, length(v));
    return most;
}

/// How far anybody gets within so many steps [m]: who stands in a crush may be jostled, but stays.
double farthestMove(World& world, int steps) {
    const std::vector<Vec2> before(world.characters().position.begin(), world.characters().position.end());
    for (int s = 0; s < steps; ++s) world.step();
    double most = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
        most = std::max(most, distance(before[i], world.characters().position[i]));
    return most;
}

bool saw(const World& world, EventKind kind) {
    return std::any_of(world.events().begin(), world.events().end(),
                       [&](const Event& event) { return event.kind == kind; });
}

int stepsUntilDone(World& world, int most) {
    for (int s = 0; s < most; ++s) {
        world.step();
        if (saw(world, EventKind::OrderDone)) return s;
    }
    return -1;
}

/// A wall across the floor with free ground at its upper end.
WorldDef floorWithWall(std::int32_t count = 25) {
    WorldDef def = openFloor(count);
    def.obstacles.push_back(block(-0.5, -12, 0.5, 7));
    return def;
}

}  // namespace

TEST_CASE("a group without places goes round a wall, gathers at its target and stands there") {
    World world = World::create(floorWithWall()).value();
    const GroupId id = world.group(0).id;
    tell(world, gatherAt({7, -4}), id);
    const int steps = stepsUntilDone(world, 1500);
    REQUIRE(steps > 0);
    // The way round the end of the wall is 27 m long, and nobody is faster than the top speed.
    CHECK(steps * world.parameters().stepTime > 25.0 / world.parameters().character.maxSpeed);
    CHECK(steps * world.parameters().stepTime < 40.0 / world.parameters().character.maxSpeed);
    for (int s = 0; s < 300; ++s) world.step();
    CHECK(distance(middleOf(world), Vec2{7, -4}) < 1.0);
    CHECK(farthest(world, {7, -4}) < 2.6);
    CHECK(fastest(world) < 0.1);
    for (const std::int32_t place : world.characters().place) CHECK(place == -1);
}

TEST_CASE("nobody is faster, and bodies keep apart as with other orders") {
    World world = World::create(floorWithWall(36)).value();
    tell(world, gatherAt({7, 4}));
    const double diameter = 2.0 * world.parameters().character.radius;
    for (int s = 0; s < 700; ++s) {
        world.step();
        CHECK(fastest(world) <= world.parameters().character.maxSpeed + 1e-9);
        if (s % 50 != 0) continue;
        const auto positions = world.characters().position;
        int deep = 0;
        for (std::size_t i = 0; i < positions.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                deep += distance(positions[i], positions[j]) < 0.9 * diameter ? 1 : 0;
        CHECK(deep <= 2);
    }
}

TEST_CASE("two groups go through each other") {
    WorldDef def = openFloor(16);
    GroupDef other = def.groups[0];
    other.position = {6, 0};
    def.groups.push_back(other);
    World world = World::create(def).value();
    tell(world, gatherAt({6, 0}));
    tell(world, gatherAt({-6, 0}), 1);
    for (int s = 0; s < 1500; ++s) world.step();
    CHECK(distance(middleOf(world, 0), Vec2{6, 0}) < 1.0);
    CHECK(distance(middleOf(world, 1), Vec2{-6, 0}) < 1.0);
    CHECK(fastest(world) < 0.1);
}

TEST_CASE("a target within an obstacle is gathered at where ground is free; one that is cut off is told") {
    WorldDef def = openFloor(16);
    def.obstacles.push_back(tree({6, 0}, 1.0));
    World world = World::create(def).value();
    tell(world, gatherAt({6, 0}));
    REQUIRE(stepsUntilDone(world, 1500) > 0);
    for (int s = 0; s < 1200; ++s) world.step();
    CHECK(farthest(world, {6, 0}) < 4.5);
    CHECK(farthestMove(world, 300) < 0.2);

    WorldDef walled = openFloor(16);
    walled.obstacles.push_back(block(-0.5, -12, 0.5, 12));
    World cut = World::create(walled).value();
    tell(cut, gatherAt({6, 0}));
    bool told = false, done = false;
    for (int s = 0; s < 1800; ++s) {
        cut.step();
        told = told || saw(cut, EventKind::NoPath);
        done = done || saw(cut, EventKind::OrderDone);
    }
    CHECK(told);
    CHECK(done);
    CHECK(middleOf(cut).x < 0.0);
    CHECK(fastest(cut) < 0.1);
}

TEST_CASE("a snapshot in the middle of a continuum order goes on bit for bit") {
    WorldDef def = floorWithWall();
    ObstacleDef car = tree({0, 9}, 0.8);
    car.path = {.waypoints = {{0, {0, 0}, 0}, {4, {6, 0}, 0}, {8, {0, 0}, 0}}, .loop = true};
    def.obstacles.push_back(car);
    World world = World::create(def).value();
    const GroupId id = world.group(0).id;
    tell(world, gatherAt({7, -4}), id);
    const auto split = [&](World& each) {
        if (each.stepCount() == 100)
            REQUIRE(
                give(each,
                     SplitGroup{
                         .group = id, .by = SplitBy::Shares, .shares = {1, 1}, .shape = PartShape::Smaller})
                    .ok());
    };
    for (const std::uint32_t cut : {3u, 61u, 140u, 233u, 500u}) {
        while (world.stepCount() < cut) {
            split(world);
            world.step();
        }
        checkGoesOn(world, 40, split);
    }
}

TEST_CASE("queued points are passed one after the other, and a stop stops") {
    World world = World::create(openFloor()).value();
    const GroupId id = world.group(0).id;
    tell(world, gatherAt({6, 8}), id);
    REQUIRE(give(world, GiveOrder{id, QueueMode::Append, 0, gatherAt({6, -8})}).ok());
    double highest = -12.0;
    for (int s = 0; s < 1400; ++s) {
        world.step();
        highest = std::max(highest, middleOf(world).y);
    }
    CHECK(highest > 6.5);
    CHECK(distance(middleOf(world), Vec2{6, -8}) < 0.8);
    tell(world, gatherAt({-6, -8}), id);
    for (int s = 0; s < 120; ++s) world.step();
    CHECK(fastest(world) > 1.0);
    REQUIRE(give(world, EditQueue{id, QueueEdit::Stop, 0}).ok());
    for (int s = 0; s < 120; ++s) world.step();
    const Vec2 stopped = middleOf(world);
    CHECK(fastest(world) < 0.1);
    for (int s = 0; s < 240; ++s) world.step();
    CHECK(distance(middleOf(world), stopped) < 0.2);
}

TEST_CASE("other orders and poses give everybody a place again") {
    World world = World::create(openFloor()).value();
    const GroupId id = world.group(0).id;
    tell(world, gatherAt({6, 0}), id);
    for (int s = 0; s < 600; ++s) world.step();
    tell(world, Order::move({-6, 0}), id);
    bool arrived = false;
    for (int s = 0; s < 1200; ++s) {
        world.step();
        arrived = arrived || saw(world, EventKind::Arrived);
    }
    CHECK(arrived);
    for (const std::int32_t place : world.characters().place) CHECK(place >= 0);
    tell(world, gatherAt({6, 0}), id);
    for (int s = 0; s < 600; ++s) world.step();
    REQUIRE(give(world, SetPose{id, {0, 5}, 0.0}).ok());
    for (int s = 0; s < 600; ++s) world.step();
    CHECK(distance(middleOf(world), Vec2{0, 5}) < 0.3);
}
