// Everyone for themselves where the group cannot: own speeds and brakes, orders that cannot be carried out,
// and groups that hold their ground.
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef lane(std::int32_t count, Vec2 at) {
    return {.box = {{-60, -20}, {60, 20}}, .groups = {{.count = count, .position = at}}};
}

Body bodyOf(double maxSpeed, double acceleration) {
    return {.maxSpeed = maxSpeed, .acceleration = acceleration};
}

Order freely(Vec2 target) {
    Order order = Order::move(target);
    order.manner = Manner::Free;
    return order;
}

}  // namespace

TEST_CASE("weak brakes stop in time, freely and on a march") {
    for (const bool march : {false, true}) {
        WorldDef def = lane(1, {-40, 0});
        def.groups[0].bodies = {bodyOf(2.0, 0.3)};
        World world = World::create(def).value();
        tell(world, march ? Order::move({40, 0}) : freely({40, 0}));
        double farthest = -1e9, arrived = 1e9;
        for (int s = 0; s < 70 * 60; ++s) {
            world.step();
            const Vec2 p = world.characters().position[0];
            farthest = std::max(farthest, p.x);
            if (distance(p, {40, 0}) < 0.3) arrived = std::min(arrived, world.time());
        }
        CAPTURE(march);
        CHECK(farthest < 40.3);
        // 80 m at 2 m/s, and as long again as it takes to reach that speed, with four fifths of it to brake.
        CHECK(arrived < 52.0);
    }
}

TEST_CASE("who is faster than the others usually are walks at its own speed, freely and on a march") {
    for (const bool march : {false, true}) {
        WorldDef def = lane(1, {-45, 0});
        def.groups[0].bodies = {bodyOf(6.0, 0.0)};
        World world = World::create(def).value();
        tell(world, march ? Order::move({45, 0}) : freely({45, 0}));
        double arrived = 1e9;
        for (int s = 0; s < 40 * 60; ++s) {
            world.step();
            if (distance(world.characters().position[0], {45, 0}) < 0.5)
                arrived = std::min(arrived, world.time());
        }
        CAPTURE(march);
        CHECK(arrived < 20.0);
        CHECK(arrived >= 15.0);
    }
}

TEST_CASE("without cohesion two slow ones of sixty are left behind, with it nobody is") {
    double seconds[2];
    for (const bool together : {false, true}) {
        WorldDef def = lane(60, {-30, 0});
        def.groups[0].bodies.assign(60, bodyOf(2.0, 0.0));
        def.groups[0].bodies[20].maxSpeed = def.groups[0].bodies[40].maxSpeed = 0.8;
        def.groups[0].conduct.cohesion = together ? 1.0 : 0.0;
        World world = World::create(def).value();
        tell(world, Order::move({10, 0}));
        seconds[together] = 1e9;
        for (int s = 0; s < 80 * 60 && seconds[together] > 1e8; ++s) {
            world.step();
            int there = 0;
            for (const Vec2 p : world.characters().position) there += distance(p, {10, 0}) < 6.0 ? 1 : 0;
            if (there >= 58) seconds[together] = world.time();
        }
    }
    CHECK(seconds[0] < 26.0);
    CHECK(seconds[1] > 40.0);
}

TEST_CASE("a group that holds its ground stays where it stands when a friend is ordered there") {
    WorldDef def = lane(4, {-10, 0});
    GroupDef holder = def.groups[0];
    holder.position = {5, 0};
    holder.conduct.stance = Stance::Hold;
    def.groups.push_back(holder);
    World world = World::create(def).value();
    for (int s = 0; s < 30; ++s) world.step();
    const std::vector<Vec2> before(world.characters().position.begin(), world.characters().position.end());
    tell(world, freely({5, 0}));
    double moved = 0.0;
    for (int s = 0; s < 40 * 60; ++s) {
        world.step();
        for (std::size_t i = 4; i < 8; ++i)
            moved = std::max(moved, distance(world.characters().position[i], before[i]));
    }
    CHECK(moved < 0.3);
    CHECK(world.contacts().overlapPairs == 0);
}

TEST_CASE("a target that is built over on the way is told at once, and ends as skipped") {
    World world = World::create(lane(9, {-30, 0})).value();
    tell(world, Order::move({20, 0}));
    for (int s = 0; s < 240; ++s) world.step();
    REQUIRE(give(world, putThing(block(14, -6, 26, 6))).ok());
    world.step();
    int noPath = 0, skipped = 0, arrived = 0, done = 0;
    const auto count = [&] {
        for (const Event& event : world.events()) {
            noPath += event.kind == EventKind::NoPath ? 1 : 0;
            skipped += event.kind == EventKind::OrderSkipped ? 1 : 0;
            arrived += event.kind == EventKind::Arrived ? 1 : 0;
            done += event.kind == EventKind::OrderDone ? 1 : 0;
        }
    };
    count();
    CHECK(noPath == 1);
    for (int s = 0; s < 50 * 60; ++s) {
        world.step();
        count();
    }
    CHECK(noPath == 1);
    CHECK(skipped == 1);
    CHECK(arrived == 0);
    CHECK(done == 0);
    double apart = 0.0;
    for (const Vec2 p : world.characters().position)
        for (const Vec2 q : world.characters().position) apart = std::max(apart, distance(p, q));
    CHECK(apart < 6.0);
}

TEST_CASE("arrivals are counted from where an order ends, with places and without") {
    for (const bool continuum : {false, true}) {
        World world = World::create(lane(16, {-20, 0})).value();
        RunMetrics metrics(world);
        Order what = Order::move({20, 0});
        if (continuum) what.manner = Manner::Continuum;
        tell(world, what);
        double last = 0.0;
        for (int s = 0; s < 40 * 60; ++s) {
            const Vec2 before = world.characters().position[0];
            world.step();
            metrics.observe(world);
            if (distance(before, world.characters().position[0]) > 0.002) last = world.time();
        }
        const RunFigures figures = metrics.figures(world, false);
        CAPTURE(continuum);
        CHECK(figures.unmatched == 0);
        CHECK(figures.stuck == 0);
        CHECK(figures.arrived100 > 17.0);
        CHECK(figures.arrived100 < last + 2.0);
    }
}
