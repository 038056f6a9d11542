// Orders that are carried out by one continuum field: nobody has a place, all go to one point.
#include <doctest.h>

#include <algorithm>

#include "engine/world/scenes.h"

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
    std::uint32_t n = 0;
    const GroupId id = world.group(0).id;
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, gatherAt({7, -4})}).ok());
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
    std::uint32_t n = 0;
    REQUIRE(give(world, n, GiveOrder{world.group(0).id, QueueMode::Replace, 0, gatherAt({7, 4})}).ok());
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
    std::uint32_t n = 0;
    REQUIRE(give(world, n, GiveOrder{world.group(0).id, QueueMode::Replace, 0, gatherAt({6, 0})}).ok());
    REQUIRE(give(world, n, GiveOrder{world.group(1).id, QueueMode::Replace, 0, gatherAt({-6, 0})}).ok());
    for (int s = 0; s < 1500; ++s) world.step();
    CHECK(distance(middleOf(world, 0), Vec2{6, 0}) < 1.0);
    CHECK(distance(middleOf(world, 1), Vec2{-6, 0}) < 1.0);
    CHECK(fastest(world) < 0.1);
}

TEST_CASE("a target within an obstacle is gathered at where ground is free; one that is cut off is told") {
    WorldDef def = openFloor(16);
    def.obstacles.push_back(tree({6, 0}, 1.0));
    World world = World::create(def).value();
    std::uint32_t n = 0;
    REQUIRE(give(world, n, GiveOrder{world.group(0).id, QueueMode::Replace, 0, gatherAt({6, 0})}).ok());
    REQUIRE(stepsUntilDone(world, 1500) > 0);
    for (int s = 0; s < 1200; ++s) world.step();
    CHECK(farthest(world, {6, 0}) < 4.5);
    CHECK(farthestMove(world, 300) < 0.2);

    WorldDef walled = openFloor(16);
    walled.obstacles.push_back(block(-0.5, -12, 0.5, 12));
    World cut = World::create(walled).value();
    n = 0;
    REQUIRE(give(cut, n, GiveOrder{cut.group(0).id, QueueMode::Replace, 0, gatherAt({6, 0})}).ok());
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
    car.path.waypoints = {{0, {0, 0}, 0}, {4, {6, 0}, 0}, {8, {0, 0}, 0}};
    car.path.loop = true;
    def.obstacles.push_back(car);
    World world = World::create(def).value();
    std::uint32_t n = 0;
    const GroupId id = world.group(0).id;
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, gatherAt({7, -4})}).ok());
    SplitGroup split;
    split.group = id;
    split.by = SplitBy::Shares;
    split.shares = {1, 1};
    split.shape = PartShape::Smaller;
    for (const int cut : {3, 61, 140, 233, 500}) {
        while (world.stepCount() < static_cast<std::uint32_t>(cut)) {
            if (world.stepCount() == 100) REQUIRE(give(world, n, split).ok());
            world.step();
        }
        const auto bytes = world.snapshot();
        Result<World> copy = World::restore(bytes, 2);
        REQUIRE_MESSAGE(copy.ok(), copy.status().message());
        World rewound = World::create(def).value();
        for (int s = 0; s < 30; ++s) rewound.step();
        REQUIRE(rewound.rewind(bytes).ok());
        World original = World::restore(bytes, 1).value();
        for (int s = 0; s < 40; ++s) {
            original.step();
            copy->step();
            rewound.step();
            REQUIRE(copy->hash() == original.hash());
            REQUIRE(rewound.hash() == original.hash());
        }
        // The world that went on without a break does the same.
        World unbroken = World::create(def).value();
        std::uint32_t m = 0;
        REQUIRE(give(unbroken, m, GiveOrder{id, QueueMode::Replace, 0, gatherAt({7, -4})}).ok());
        while (unbroken.stepCount() < static_cast<std::uint32_t>(cut) + 40) {
            if (unbroken.stepCount() == 100) REQUIRE(give(unbroken, m, split).ok());
            unbroken.step();
        }
        if (cut + 40 <= 100 || cut >= 101) CHECK(unbroken.hash() == original.hash());
    }
}

TEST_CASE("queued points are passed one after the other, and a stop stops") {
    World world = World::create(openFloor()).value();
    std::uint32_t n = 0;
    const GroupId id = world.group(0).id;
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, gatherAt({6, 8})}).ok());
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Append, 0, gatherAt({6, -8})}).ok());
    double highest = -12.0;
    for (int s = 0; s < 1400; ++s) {
        world.step();
        highest = std::max(highest, middleOf(world).y);
    }
    CHECK(highest > 6.5);
    CHECK(distance(middleOf(world), Vec2{6, -8}) < 0.8);
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, gatherAt({-6, -8})}).ok());
    for (int s = 0; s < 120; ++s) world.step();
    CHECK(fastest(world) > 1.0);
    REQUIRE(give(world, n, EditQueue{id, QueueEdit::Stop, 0}).ok());
    for (int s = 0; s < 120; ++s) world.step();
    const Vec2 stopped = middleOf(world);
    CHECK(fastest(world) < 0.1);
    for (int s = 0; s < 240; ++s) world.step();
    CHECK(distance(middleOf(world), stopped) < 0.2);
}

TEST_CASE("other orders and poses give everybody a place again") {
    World world = World::create(openFloor()).value();
    std::uint32_t n = 0;
    const GroupId id = world.group(0).id;
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, gatherAt({6, 0})}).ok());
    for (int s = 0; s < 600; ++s) world.step();
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, Order::move({-6, 0})}).ok());
    bool arrived = false;
    for (int s = 0; s < 1200; ++s) {
        world.step();
        arrived = arrived || saw(world, EventKind::Arrived);
    }
    CHECK(arrived);
    for (const std::int32_t place : world.characters().place) CHECK(place >= 0);
    REQUIRE(give(world, n, GiveOrder{id, QueueMode::Replace, 0, gatherAt({6, 0})}).ok());
    for (int s = 0; s < 600; ++s) world.step();
    REQUIRE(give(world, n, SetPose{id, {0, 5}, 0.0}).ok());
    for (int s = 0; s < 600; ++s) world.step();
    CHECK(distance(middleOf(world), Vec2{0, 5}) < 0.3);
}
