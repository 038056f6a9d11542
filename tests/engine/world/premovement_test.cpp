// Premovement: persons stand from the first order of their group on until their time is over.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/world/played.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr std::uint32_t kNever = 0xffffffff;

// A group whose members set out after these times [s], at the left of a floor.
WorldDef waitingFloor(const std::vector<double>& times) {
    WorldDef def = openFloor(static_cast<std::int32_t>(times.size()));
    for (const double time : times) def.groups[0].bodies.push_back({.premovement = time});
    return def;
}

// The step in which each first moves, of so many seconds; kNever for none.
std::vector<std::uint32_t> firstMoves(Played& played, double seconds) {
    const std::vector<Vec2> starts = copyOf(played.world.characters().position);
    std::vector<std::uint32_t> moved(starts.size(), kNever);
    const auto steps = std::lround(seconds / played.world.parameters().stepTime);
    for (long s = 0; s < steps; ++s) {
        const std::uint32_t step = played.world.stepCount();
        played.run(played.world.parameters().stepTime);
        for (std::size_t i = 0; i < starts.size(); ++i)
            if (moved[i] == kNever && !(played.world.characters().position[i] == starts[i])) moved[i] = step;
    }
    return moved;
}

int raisedOf(const World& world, EventKind kind) {
    return static_cast<int>(std::count_if(world.events().begin(), world.events().end(),
                                          [&](const Event& event) { return event.kind == kind; }));
}

const std::vector<double> kTenTimes{10, 20, 30, 40, 50, 60, 70, 80, 90, 100};

}  // namespace

TEST_CASE("ten persons set out in exactly their steps, by every kind of order") {
    for (const double stepTime : {1.0 / 60.0, 0.1, 1.0 / 30.0}) {
        for (int kind = 0; kind < 4; ++kind) {
            // Others pass by those who stand yet.
            if (kind > 0 && stepTime != 0.1) continue;
            WorldDef def = waitingFloor(kTenTimes);
            def.parameters.stepTime = stepTime;
            def.groups.push_back({.count = 1, .position = {8, 8}});
            Played played(def);
            const std::vector<Order> orders{Order::move({8, 0}), Order::go({8, 0}),
                                            Order::follow(GroupId{2}, {-3, -8}),
                                            Order::guard({6, -2}, {1, 1}, 0.0)};
            Order order = orders[kind];
            played.run(2.0);
            const std::uint32_t told = played.world.stepCount();
            played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, order});
            const std::vector<std::uint32_t> moved = firstMoves(played, 102.0);
            CAPTURE(stepTime);
            CAPTURE(kind);
            for (std::size_t i = 0; i < kTenTimes.size(); ++i)
                CHECK(moved[i] == told + std::lround(kTenTimes[i] / stepTime));
            played.run(12.0);
            CHECK(played.farthest(0) < 0.5);
        }
    }
}

TEST_CASE("a person with premovement neither moves nor turns before its time, and others go round it") {
    WorldDef def = waitingFloor({30.0});
    def.groups[0].position = {0, 0};
    def.groups[0].orders = {Order::move({0, 6})};
    def.groups.push_back(
        {.count = 6, .formation = {.spacing = 0.8}, .position = {-8, 0}, .orders = {Order::move({8, 0})}});
    for (const Manner manner : {Manner::March, Manner::Free}) {
        def.groups[1].orders[0].manner = manner;
        Played played(def);
        const Vec2 start = played.world.characters().position[0],
                   heading = played.world.characters().heading[0];
        int steps = 0;
        while (played.farthest(1) > 0.5 || played.world.time() < 5.0) {
            played.run(played.world.parameters().stepTime);
            REQUIRE(++steps < 900);
        }
        CHECK(played.world.characters().heading[0] == heading);
        CHECK(distance(played.world.characters().position[0], start) < 0.05);
        CHECK(played.world.time() < 11.5);  // 16 m at 2 m/s or so.
        CHECK(played.deepest < 0.1);
    }
}

TEST_CASE("who stands before its time is over is not stuck, does not hold up its march, and arrives") {
    WorldDef def = waitingFloor({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 40.0, 0.0, 0.0});
    Played played(def);
    played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({6, 0})});
    int stuck = 0, arrived = 0, done = 0;
    double doneAt = 0.0;
    for (int s = 0; s < 60 * 60; ++s) {
        played.run(1.0 / 60.0);
        stuck += raisedOf(played.world, EventKind::Stuck);
        arrived += raisedOf(played.world, EventKind::Arrived);
        const int now = raisedOf(played.world, EventKind::OrderDone);
        if (now > 0) doneAt = played.world.time();
        done += now;
        if (played.world.time() < 39.9 && played.world.time() > 15.0) {
            int there = 0;
            const CharactersView c = played.world.characters();
            for (std::size_t i = 0; i < c.size(); ++i)
                there += distance(c.position[i], played.world.group(0).placePositions[c.place[i]]) < 0.5;
            CHECK(there == 8);
            if (there != 8) break;
        }
    }
    CHECK(stuck == 0);
    CHECK(arrived == 1);
    CHECK(done == 1);
    CHECK(doneAt > 40.0);
    CHECK(played.farthest(0) < 0.5);
}

TEST_CASE("nobody counts as stuck while all stand yet, and the order goes on") {
    WorldDef def = waitingFloor({25.0, 25.0, 26.0, 26.0});
    for (const Manner manner : {Manner::March, Manner::Free, Manner::Continuum}) {
        Played played(def);
        Order order = Order::move({6, 0});
        order.manner = manner;
        played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, order});
        int done = 0, stuck = 0;
        for (int s = 0; s < 25 * 60; ++s) {
            played.run(1.0 / 60.0);
            done += raisedOf(played.world, EventKind::OrderDone);
            stuck += raisedOf(played.world, EventKind::Stuck);
        }
        CHECK(done == 0);
        CHECK(stuck == 0);
        played.run(20.0);
        CHECK(middleOf(played.world).x > 5.0);
    }
}

TEST_CASE("times count from the first order, also of who joins, and run once") {
    Played played(waitingFloor({3.0, 3.0}));
    played.run(5.0);
    played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({0, 0})});
    const std::vector<Vec2> starts = copyOf(played.world.characters().position);
    played.run(2.0);
    Body late{.premovement = 4.0};
    played.give(AddCharacters{GroupId{1}, {{-6, 8}}, {late}});
    played.run(1.0);
    CHECK(copyOf(played.world.characters().position)[0] == starts[0]);
    const Vec2 joined = played.world.characters().position[2];
    played.run(2.9);
    CHECK(distance(played.world.characters().position[0], starts[0]) > 2.0);
    CHECK(played.world.characters().position[2] == joined);
    played.run(1.0);
    CHECK(distance(played.world.characters().position[2], joined) > 0.5);
    // The next order finds all under way.
    played.run(20.0);
    const Vec2 rest = played.world.characters().position[2];
    played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({6, -6})});
    played.run(1.0);
    CHECK(distance(played.world.characters().position[2], rest) > 0.3);
}

TEST_CASE("a snapshot within the times goes on bit for bit") {
    Played played(waitingFloor(kTenTimes));
    played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({8, 0})});
    played.run(33.0);
    checkGoesOn(played.world, 600);
}

TEST_CASE("persons leave a room at their own times, as one group, and none who has not set out") {
    WorldDef def{.box = {{-6, -4}, {6, 4}}};
    // RiMEA 5: a room of 8 m by 5 m with an exit of 1 m; one stands in the exit area itself.
    def.obstacles = {block(-4.2, -2.7, 4.2, -2.5), block(-4.2, 2.5, 4.2, 2.7), block(-4.2, -2.5, -4, 2.5),
                     block(4, -2.5, 4.2, -0.5), block(4, 0.5, 4.2, 2.5)};
    def.areas = {{.polygon = {{4.3, -0.6}, {5.8, -0.6}, {5.8, 0.6}, {4.3, 0.6}}}};
    GroupDef group{.count = 10, .people = {PeopleDef{}}};
    group.people[0].premovement = Distribution::uniform(10.0, 100.0);
    for (int k = 0; k < 9; ++k) group.starts.push_back({-3.2 + 1.5 * (k % 3), -1.6 + 1.6 * (k / 3)});
    group.starts.push_back({5.2, 0.0});
    group.orders = {Order::leave()};
    def.groups.push_back(group);
    Played played(def);
    const std::vector<Body> bodies = copyOf(played.world.characters().body);
    const std::vector<Vec2> starts = copyOf(played.world.characters().position);
    std::vector<std::uint32_t> moved(10, kNever), left(10, kNever);
    while (played.world.stepCount() < 6600 && played.world.characters().size() > 0) {
        const std::uint32_t step = played.world.stepCount();
        played.run(1.0 / 60.0);
        const CharactersView c = played.world.characters();
        for (std::size_t k = 0; k < c.size(); ++k)
            if (moved[c.id[k] - 1] == kNever && !(c.position[k] == starts[c.id[k] - 1]))
                moved[c.id[k] - 1] = step;
        for (const Event& event : played.world.events())
            if (event.kind == EventKind::Exited) left[event.subject - 1] = step;
    }
    for (std::size_t i = 0; i < 10; ++i) {
        const auto sets = static_cast<std::uint32_t>(std::ceil(bodies[i].premovement * 60.0 - 1e-9));
        CAPTURE(i);
        if (i < 9) CHECK(moved[i] == sets);
        CHECK(left[i] >= sets);
        CHECK(left[i] < sets + (i < 9 ? 600 : 3));
    }
}
