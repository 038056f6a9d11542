// How orders get on: each event where a scene of known outcome asks for it, once, and also after a snapshot.
#include <doctest.h>

#include <algorithm>

#include "base/maths.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

struct Told {
    std::uint32_t step = 0;
    Event event;
    friend bool operator==(const Told&, const Told&) = default;
};

/// Steps a world and keeps what is told of orders.
std::vector<Told> watch(World& world, int steps) {
    std::vector<Told> told;
    for (int s = 0; s < steps; ++s) {
        world.step();
        for (const Event& event : world.events())
            if (isOrderEvent(event.kind)) told.push_back({world.stepCount(), event});
    }
    return told;
}

std::vector<EventKind> kindsOf(const std::vector<Told>& told) {
    std::vector<EventKind> kinds;
    for (const Told& one : told) kinds.push_back(one.event.kind);
    return kinds;
}

auto countOf(const std::vector<Told>& told, EventKind kind) {
    return std::count_if(told.begin(), told.end(), [&](const Told& one) { return one.event.kind == kind; });
}

/// Walls of a floor of 24 m: the right side of it can be reached by a door round (0, 0), where it is open.
WorldDef twoHalves(double door, std::int32_t count = 16) {
    WorldDef def = openFloor(count);
    def.obstacles = {block(-0.5, -12, 0.5, -door / 2), block(-0.5, door / 2, 0.5, 12)};
    return def;
}

SetPose poseAt(const World& world, Vec2 p) {
    return {world.group(0).id, p, 0.0};
}

}  // namespace

TEST_CASE("an order is told as carried out once, one second after the last is within reach") {
    World world = World::create(openFloor(16)).value();
    CHECK(watch(world, 180).empty());  // Who stand at their places from the beginning are told of nothing.
    for (const double x : {4.0, -4.0}) {
        REQUIRE(give(world, poseAt(world, {x, 0})).ok());
        const auto told = watch(world, 900);
        REQUIRE(kindsOf(told) == std::vector{EventKind::Arrived});
        CHECK(told[0].event.subject == world.group(0).id.value);
        CHECK(told[0].event.value == 16);
        CHECK(distance(told[0].event.position, {x, 0}) < 0.01);
    }
    REQUIRE(give(world, poseAt(world, {-4, 0.1})).ok());  // Nobody is ever out of reach.
    const auto told = watch(world, 120);
    REQUIRE(kindsOf(told) == std::vector{EventKind::Arrived});
    CHECK(told[0].step == 180 + 1800 + 61);
}

TEST_CASE("arrival is told in the very step that the definition gives") {
    World world = World::create(openFloor(16)).value();
    watch(world, 30);
    REQUIRE(give(world, poseAt(world, {5, 2})).ok());
    std::uint32_t outside = 0,
                  moving = 0;  // The last steps with somebody out of reach, and with a moving place.
    for (int s = 0; s < 1200; ++s) {
        const auto told = watch(world, 1);
        const CharactersView c = world.characters();
        const GroupView group = world.group(0);
        for (std::size_t i = 0; i < c.size(); ++i)
            if (distance(c.position[i], group.placePositions[c.place[i]]) > 0.5) outside = world.stepCount();
        for (const Vec2 v : group.placeVelocities)
            if (length(v) > 0.1) moving = world.stepCount();
        if (told.empty()) continue;
        CHECK(moving > 60);
        CHECK(world.stepCount() == std::max(outside + 61, moving + 1));
        return;
    }
    FAIL("nobody was told");
}

TEST_CASE("a drawn way is told as carried out when the finger's path is followed") {
    World world = World::create(openFloor(16)).value();
    REQUIRE(give(world, Touch{TouchPhase::Down, 1, {-6, 0}, world.time(), {}}).ok());
    CHECK(watch(world, 30).empty());
    REQUIRE(give(world, Touch{TouchPhase::Move, 1, {4, 0}, world.time(), {}}).ok());
    CHECK(watch(world, 120).empty());
    REQUIRE(give(world, Touch{TouchPhase::Up, 1, {}, world.time(), {}}).ok());
    CHECK(kindsOf(watch(world, 1200)) == std::vector{EventKind::Arrived});
}

TEST_CASE("no path and partial tell how many places cannot be reached, once per order") {
    World world = World::create(twoHalves(0.0)).value();
    CHECK(watch(world, 60).empty());
    for (int order = 0; order < 2; ++order) {
        REQUIRE(give(world, poseAt(world, {6, 0})).ok());
        auto told = watch(world, 600);
        REQUIRE(!told.empty());
        CHECK(told[0].event.kind == EventKind::NoPath);
        CHECK(told[0].event.value == 16);
        CHECK(distance(told[0].event.position, {6, 0}) < 0.2);
        CHECK(countOf(told, EventKind::NoPath) == 1);
    }
    // The right half of the formation lies beyond the wall.
    REQUIRE(give(world, poseAt(world, {0, 0})).ok());
    const auto told = watch(world, 600);
    REQUIRE(!told.empty());
    CHECK(told[0].event.kind == EventKind::Partial);
    CHECK(told[0].event.value == 8);
}

TEST_CASE("who are cut off by the ground are told of, and when they have their way again") {
    World world = World::create(twoHalves(3.0)).value();
    REQUIRE(give(world, poseAt(world, {6, 0})).ok());
    CHECK(watch(world, 60).empty());  // On their way.
    REQUIRE(give(world, putThing(block(-0.4, -2, 0.4, 2))).ok());
    auto told = watch(world, 60);
    REQUIRE(kindsOf(told) == std::vector{EventKind::Blocked});
    CHECK(told[0].event.value == 16);
    const ObstacleId gate = world.obstacleIds().back();
    REQUIRE(give(world, putThing(tree({-9, 9}, 0.5))).ok());  // Another version, the same ways.
    CHECK(watch(world, 60).empty());
    REQUIRE(give(world, removeThing(gate)).ok());
    told = watch(world, 900);
    CHECK(kindsOf(told) == std::vector{EventKind::Free, EventKind::Arrived});
    CHECK(told[0].event.value == 16);
}

TEST_CASE("some of a group who are cut off from the others are counted") {
    WorldDef def = openFloor(8);
    def.groups[0].position = {6, 0};
    for (int i = 0; i < 8; ++i) def.groups[0].starts.push_back(i < 3 ? Vec2{-8, i - 1.0} : Vec2{5, i - 5.0});
    World world = World::create(def).value();
    REQUIRE(give(world, putThing(block(-0.5, -12, 0.5, 12))).ok());
    const auto told = watch(world, 60);
    REQUIRE(kindsOf(told) == std::vector{EventKind::Blocked});
    CHECK(told[0].event.value == 3);
    CHECK(told[0].event.position.x < -5.0);
}

TEST_CASE("who stands before a gap too narrow is stuck, who queues at a door is not") {
    SUBCASE("one among posts") {
        WorldDef def = openFloor(1);
        def.groups[0].position = {6, 0};
        def.groups[0].starts = {{-6, 0}};
        World world = World::create(def).value();
        watch(world, 20);
        // Moving things do not count as ground: they stand in the way until they leave, after 20 s.
        const Vec2 middle = world.characters().position[0];
        for (int k = 0; k < 8; ++k) {
            ObstacleDef post = tree(
                middle + Rotation{cosine(k * 0.25 * kPi), sine(k * 0.25 * kPi)}.apply({0.85, 0}), 0.5);
            post.path.waypoints = {{0, {0, 0}, 0}, {20, {0, 0}, 0}, {20.5, {0, 30}, 0}};
            REQUIRE(give(world, putThing(post)).ok());
        }
        const auto told = watch(world, 19 * 60);
        CHECK(countOf(told, EventKind::Stuck) == 1);
        const auto later = watch(world, 20 * 60);
        CHECK(countOf(later, EventKind::Stuck) == 0);
        CHECK(countOf(later, EventKind::Arrived) == 1);
    }
    SUBCASE("sixty at a door of one person's width") {
        WorldDef def = twoHalves(0.8, 60);
        def.parameters.opposing.gain = 0.0;
        World world = World::create(def).value();
        REQUIRE(give(world, poseAt(world, {6, 0})).ok());
        const auto later = watch(world, 60 * 60);
        CHECK(countOf(later, EventKind::Stuck) == 0);
        CHECK(countOf(later, EventKind::Arrived) == 1);
    }
}

TEST_CASE("a gate that closes the only way is told of, and when it opens; one that only passes is not") {
    // A gate 1 m thick slides along the wall before the door, which is 3 m wide.
    const auto doorWithGate = [](std::vector<Waypoint> way) {
        WorldDef def = twoHalves(3.0);
        ObstacleDef gate = block(-1.6, -2, -0.6, 2);
        gate.path.waypoints = std::move(way);
        def.obstacles.push_back(gate);
        return def;
    };
    SUBCASE("closed from 1 s to 16 s") {
        const auto run = [&](std::uint32_t restoredAt) {
            World world = World::create(doorWithGate({{0, {0, 8}, 0},
                                                      {0.8, {0, 8}, 0},
                                                      {1.2, {0, 0}, 0},
                                                      {16, {0, 0}, 0},
                                                      {17, {0, 8}, 0}}))
                              .value();
            REQUIRE(give(world, poseAt(world, {6, 0})).ok());
            auto told = watch(world, static_cast<int>(restoredAt));
            if (restoredAt > 0) world = World::restore(world.snapshot()).value();
            for (const Told& one : watch(world, 1800 - static_cast<int>(restoredAt))) told.push_back(one);
            return told;
        };
        auto told = run(0);
        std::erase_if(told, [](const Told& one) { return one.event.kind == EventKind::Stuck; });
        REQUIRE(kindsOf(told) == std::vector{EventKind::Blocked, EventKind::Free, EventKind::Arrived});
        CHECK(told[0].event.value > 8);
        CHECK(told[0].event.position.x < -1.0);
        CHECK(told[0].step < 8 * 60);
        CHECK(told[1].event.value == told[0].event.value);
        CHECK(told[1].step > 16 * 60);
        CHECK(told[1].step < 19 * 60);
        for (const std::uint32_t cut : {200u, 500u, 1000u}) CHECK(run(cut) == run(0));
    }
    SUBCASE("closed for 1.5 s") {
        World world = World::create(doorWithGate({{0, {0, 8}, 0},
                                                  {2.5, {0, 8}, 0},
                                                  {3, {0, 0}, 0},
                                                  {4, {0, 0}, 0},
                                                  {4.5, {0, 8}, 0}}))
                          .value();
        REQUIRE(give(world, poseAt(world, {6, 0})).ok());
        CHECK(kindsOf(watch(world, 1800)) == std::vector{EventKind::Arrived});
    }
    SUBCASE("one that is taken away") {
        World world = World::create(doorWithGate({{0, {0, 0}, 0}, {1e3, {0, 0.1}, 0}})).value();
        REQUIRE(give(world, poseAt(world, {6, 0})).ok());
        auto told = watch(world, 480);
        REQUIRE(kindsOf(told) == std::vector{EventKind::Blocked});
        REQUIRE(give(world, removeThing(world.obstacleIds().back())).ok());
        told = watch(world, 1200);
        CHECK(countOf(told, EventKind::Free) == 1);
        CHECK(countOf(told, EventKind::Blocked) == 0);
        CHECK(countOf(told, EventKind::Arrived) == 1);
    }
}

TEST_CASE("a snapshot in between changes nothing of what is told") {
    for (const std::uint32_t cut : {10u, 70u, 130u, 240u}) {
        CAPTURE(cut);
        const auto run = [&](bool restored) {
            World world = World::create(twoHalves(3.0)).value();
            std::vector<Told> told;
            REQUIRE(give(world, poseAt(world, {6, 0})).ok());
            REQUIRE(world.submit({60, 2, 0, putThing(block(-0.4, -2, 0.4, 2))}).ok());
            REQUIRE(world.submit({200, 2, 1, removeThing(ObstacleId{3})}).ok());
            for (int s = 0; s < 700; ++s) {
                if (restored && world.stepCount() == cut) world = World::restore(world.snapshot()).value();
                const auto more = watch(world, 1);
                told.insert(told.end(), more.begin(), more.end());
            }
            return told;
        };
        const auto whole = run(false);
        CHECK(kindsOf(whole) == std::vector{EventKind::Blocked, EventKind::Free, EventKind::Arrived});
        CHECK(run(true) == whole);
    }
}
