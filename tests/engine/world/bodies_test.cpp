// Own bodies in worlds: gaps, mixed crowds, snapshots, movement from outside, stance, cohesion.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/played.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

Body ofRadius(double radius) {
    return {.radius = radius};
}

// A wall of 1 m from side to side but for a gap of 0.8 m in the middle and a way of 4 m at the far side.
WorldDef gapScene(double radius, std::int32_t count) {
    WorldDef def{.box = {{-16, -16}, {16, 16}},
                 .obstacles = {block(-0.5, -16, 0.5, -0.4), block(-0.5, 0.4, 0.5, 12)}};
    def.groups.push_back({.count = count,
                          .formation = {.spacing = std::max(0.9, 2.4 * radius)},
                          .position = {-6, 0},
                          .bodies = {ofRadius(radius)}});
    return def;
}

// A crowd of mixed bodies and another one that crosses it.
WorldDef mixedScene(std::uint64_t seed) {
    Random random(seed);
    WorldDef def{
        .box = {{-20, -20}, {20, 20}}, .seed = seed, .obstacles = {block(-1, 5, 2, 9), tree({3, -4}, 0.8)}};
    for (int g = 0; g < 2; ++g) {
        GroupDef group{.count = 20,
                       .formation = {.spacing = 1.5},
                       .position = {g == 0 ? -12.0 : 12.0, random.uniform(-3, 3)}};
        for (int k = 0; k < group.count; ++k)
            group.bodies.push_back({.radius = random.uniform(0.15, k % 6 == 0 ? 0.7 : 0.35),
                                    .maxSpeed = random.uniform(1.0, 3.0),
                                    .acceleration = random.uniform(2.0, 12.0),
                                    .mass = random.uniform(0.3, 8.0)});
        def.groups.push_back(group);
    }
    return def;
}

// Another body, driver, motion or conduct for somebody, or another pose for a group.
void giveAny(Played& played, Random& random) {
    const CharactersView c = played.world.characters();
    const std::uint32_t id = c.id[random.below(static_cast<std::uint32_t>(c.size()))];
    const GroupId
        group = played.world.group(random.below(static_cast<std::uint32_t>(played.world.groupCount()))).id;
    Body body{.radius = random.uniform(0.06, 1.4),
              .maxSpeed = random.uniform(0.02, 9.0),
              .acceleration = random.uniform(0.1, 30.0),
              .mass = random.uniform(0.01, 900.0)};
    Conduct conduct{.stance = static_cast<Stance>(random.below(3)), .cohesion = random.uniform(0.0, 1.0)};
    const Vec2 anywhere{random.uniform(-14, 14), random.uniform(-14, 14)};
    switch (random.below(6)) {
        case 0:
            return played.give(ChangeCharacters{{id}, std::vector<Body>{body}, {}});
        case 1:
            return played.give(ChangeCharacters{{id}, std::vector<Body>{Body{}}, {}});
        case 2:
            return played.give(
                ChangeCharacters{{id}, {}, random.below(2) != 0 ? Driver::Outside : Driver::Muster});
        case 3:
            played.give(ChangeCharacters{{id}, {}, Driver::Outside});
            return played.give(WriteMotion{{id}, {anywhere}, {}});
        case 4:
            return played.give(ChangeGroup{.group = group, .conduct = conduct});
        default:
            return played.give(SetPose{group, anywhere * 0.6, random.uniform(-3, 3)});
    }
}

}  // namespace

TEST_CASE("through a gap of 0.8 m bodies of 0.25 m go, and those of 0.6 m go round") {
    for (const double radius : {0.25, 0.6}) {
        for (const PlanSolver solver : {PlanSolver::Fast, PlanSolver::Exact}) {
            WorldDef def = gapScene(radius, 6);
            def.parameters.plan.solver = solver;
            Played played(def);
            played.give(SetPose{GroupId{1}, {6, 0}, 0.0});
            bool through = false, round = false;
            for (int second = 0; second < 60; ++second) {
                for (int part = 0; part < 10; ++part) {
                    played.run(0.1);
                    for (const Vec2 p : played.world.characters().position) {
                        through = through || (std::fabs(p.x) < 0.5 && std::fabs(p.y) < 1.0);
                        round = round || (std::fabs(p.x) < 0.5 && p.y > 11.0);
                    }
                }
            }
            for (const Vec2 p : played.world.characters().position) CHECK(p.x > 3.0);
            CAPTURE(radius);
            CHECK(played.farthest(0) < 0.5);
            CHECK(through == (radius < 0.4));
            CHECK(round == (radius > 0.4));
            CHECK(played.deepest < 0.1);
        }
    }
}

TEST_CASE("orders lead large bodies round a gap that is too narrow for them") {
    for (const Manner manner : {Manner::March, Manner::Free}) {
        for (const double radius : {0.25, 0.6}) {
            CAPTURE(radius);
            WorldDef def = gapScene(radius, 4);
            Played played(def);
            Order order = Order::move({8, 0}, 0.0);
            order.manner = manner;
            played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, order});
            bool round = false;
            for (int part = 0; part < 900; ++part) {
                played.run(0.1);
                for (const Vec2 p : played.world.characters().position)
                    round = round || (std::fabs(p.x) < 0.5 && p.y > 11.0);
            }
            CHECK(round == (radius > 0.4));
            for (const Vec2 p : played.world.characters().position) CHECK(distance(p, {8, 0}) < 3.0);
            CHECK(played.deepest < 0.1);
        }
    }
}

TEST_CASE("large bodies among small ones come to rest: places make room for them") {
    for (const std::int32_t giants : {1, 4, 20}) {
        for (const double radius : {0.6, 1.0, 1.5}) {
            CAPTURE(giants);
            CAPTURE(radius);
            WorldDef def{.box = {{-40, -30}, {40, 30}}};
            GroupDef group{.count = 60, .position = {-15, 0}};
            group.bodies.assign(60, Body{});
            for (std::int32_t k = 0; k < giants; ++k) group.bodies[k * 3] = ofRadius(radius);
            def.groups.push_back(group);
            Played played(def);
            played.run(10.0);
            played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({15, 0}, 0.0)});
            played.run(20.0);
            World copy = World::restore(played.world.snapshot()).value();
            played.run(40.0);
            for (std::uint64_t s = copy.stepCount(); s < played.world.stepCount(); ++s) copy.step();
            CHECK(copy.hash() == played.world.hash());
            CHECK(played.farthest(0) < 0.5);
            const CharactersView c = played.world.characters();
            double fastest = 0.0, gap = 1.0;
            for (std::size_t a = 0; a < c.size(); ++a) {
                fastest = std::max(fastest, length(c.velocity[a]));
                for (std::size_t b = 0; b < a; ++b)
                    gap = std::min(
                        gap, distance(c.position[a], c.position[b]) - played.radius(a) - played.radius(b));
            }
            CHECK(fastest < 0.05);
            CHECK(gap > -0.01);
        }
    }
}

TEST_CASE("mixed crowds cross without overlap, walls or loss, and snapshots and rewinds change no bit") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        Played played(mixedScene(seed));
        played.give(SetPose{GroupId{1}, {12, 0}, 0.0});
        played.give(SetPose{GroupId{2}, {-12, 1}, 0.0});
        played.run(5.0);
        checkGoesOn(played.world, 150, [&](World&) { played.watch(); });
        played.run(32.5);
        CHECK(played.deepest < 0.1);
        for (const std::size_t group : {0, 1}) CHECK(played.farthest(group) < 0.6);
        const CharactersView c = played.world.characters();
        CHECK(c.size() == 40);
        for (std::size_t i = 0; i < c.size(); ++i)
            CHECK(inspect::environment(played.world).distanceToObstacle(c.position[i]) >
                  played.radius(i) - 2e-3);
    }
}

TEST_CASE("who is given another body has it from then on; bad bodies and unknown ids are refused") {
    Played played(openFloor(9));
    Body big = ofRadius(0.5);
    big.maxSpeed = 1.0;
    played.give(ChangeCharacters{{1, 5}, std::vector<Body>{big}, {}});
    played.run(3.0);
    const CharactersView c = played.world.characters();
    CHECK(c.body[0] == big);
    CHECK(c.body[4] == big);
    CHECK(c.body[1] == Body{});
    for (std::size_t i = 1; i < c.size(); ++i)
        if (i != 4) CHECK(distance(c.position[0], c.position[i]) > 0.75 * 0.9);
    Body bad{.mass = 0.0};
    CHECK(!played.world
               .submit({played.world.stepCount(), 1, 90, ChangeCharacters{{1}, std::vector<Body>{bad}, {}}})
               .ok());
    REQUIRE(
        played.world
            .submit({played.world.stepCount(), 1, 91, ChangeCharacters{{1, 77}, std::vector<Body>{big}, {}}})
            .ok());
    played.world.step();
    REQUIRE(played.world.rejections().size() == 1);
    CHECK(played.world.rejections()[0].status.message() == "no character has the id 77");
}

TEST_CASE("random body commands leave every number finite, and snapshots and rewinds change no bit") {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        WorldDef def = busyFloor(seed);
        if (seed % 3 == 0) def.parameters.stepTime = 0.1;
        if (seed % 5 == 0) def.parameters.plan.solver = PlanSolver::Exact;
        Played played(def);
        for (int round = 0; round < 60; ++round) {
            for (int k = 0; k < 2; ++k) giveAny(played, random);
            if (round == 30) checkGoesOn(played.world, 40);
            for (int k = 0; k < 10; ++k) {
                played.world.step();
                played.watch();
            }
        }
    }
}

TEST_CASE("who does not fit through is told and stays, and the others go, and come back") {
    for (const Manner manner : {Manner::March, Manner::Free, Manner::Continuum}) {
        WorldDef def = gapScene(0.2, 12);
        def.obstacles[1] = block(-0.5, 0.4, 0.5, 16);
        def.groups[0].bodies.assign(12, ofRadius(0.2));
        def.groups[0].bodies[3] = ofRadius(0.9);
        Played played(def);
        std::uint32_t told = 0, done = 0;
        const auto go = [&](Vec2 target) {
            Order order = Order::move(target);
            order.manner = manner;
            played.give(GiveOrder{GroupId{1}, QueueMode::Replace, 0, order});
            told = done = 0;
            for (int s = 0; s < 60 * 25; ++s) {
                played.world.step();
                for (const Event& event : played.world.events()) {
                    if (event.kind == EventKind::NoPath) told += event.value;
                    done += event.kind == EventKind::OrderDone ? 1 : 0;
                }
            }
            std::int32_t beyond = 0;
            for (const Vec2 p : played.world.characters().position) beyond += p.x > 0.5 ? 1 : 0;
            CHECK(played.world.characters().position[3].x < 0.5);
            CHECK(done == 1);
            return beyond;
        };
        CAPTURE(static_cast<int>(manner));
        CHECK(go({7, 0}) == 11);
        CHECK(told == 1);
        CHECK(go({-7, 0}) == 0);
    }
}

TEST_CASE("ships with weak brakes that meet at an island keep clear in time") {
    WorldDef def{.box = {{-60, -40}, {60, 40}}, .obstacles = {tree({0, 0}, 6)}};
    Order order = Order::move({40, 0});
    order.manner = Manner::Free;
    for (const double from : {-40.0, 40.0}) {
        GroupDef group{
            .count = 8, .formation = {.spacing = 5}, .position = {from, 0}, .angle = from < 0.0 ? 0.0 : kPi};
        Body ship{.radius = 1.5, .maxSpeed = 3.0, .acceleration = 0.4};
        group.bodies.assign(8, ship);
        order.target = {-from, 0};
        group.orders = {order};
        def.groups.push_back(group);
    }
    World world = World::create(def).value();
    int done = 0;
    while (done < 2 && world.time() < 90.0) {
        world.step();
        for (const Event& e : world.events()) done += e.kind == EventKind::OrderDone ? 1 : 0;
    }
    // Alone it takes 34 s; 77 s where they look ahead for 1 s only.
    CHECK(world.time() < 60.0);
}
