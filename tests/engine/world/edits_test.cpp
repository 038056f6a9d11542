// The ground changes while the crowd is on it: obstacles and patches come, move and go.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

void runSteps(World& world, int steps) {
    for (int s = 0; s < steps; ++s) world.step();
}

double freeDistance(const World& world) {
    double least = 1e9;
    for (const Vec2 p : world.characters().position)
        least = std::min(least, inspect::environment(world).distanceToObstacle(p));
    return least;
}

std::int32_t matched(const World& world) {
    const std::span place = world.characters().place;
    return static_cast<std::int32_t>(
        std::count_if(place.begin(), place.end(), [](std::int32_t p) { return p >= 0; }));
}

}  // namespace

TEST_CASE("an obstacle set on the crowd drives it apart; taken away, all return to where they were") {
    World world = World::create(openFloor(25)).value();
    runSteps(world, 30);
    const auto before = copyOf(world.characters().position);
    REQUIRE(give(world, putThing(tree({-6, 0}, 1.2))).ok());
    runSteps(world, 1);
    CHECK(world.rejections().empty());
    REQUIRE(world.obstacleIds().size() == 1);
    // Who stands in its middle walks 1.45 m at 2 m/s, and has another second.
    for (int s = 0; s < 104; ++s) {
        const auto last = copyOf(world.characters().position);
        runSteps(world, 1);
        for (std::size_t i = 0; i < last.size(); ++i)
            CHECK(distance(world.characters().position[i], last[i]) < 1.05 * 2.0 / 60);
    }
    CHECK(freeDistance(world) > 0.25 - 1e-6);
    CHECK(world.contacts().overlapPairs == 0);
    runSteps(world, 136);
    CHECK(freeDistance(world) > 0.25 - 1e-6);
    CHECK(matched(world) == 25);
    CHECK(worstToPlace(world) < 0.2);
    REQUIRE(give(world, removeThing(world.obstacleIds()[0])).ok());
    runSteps(world, 600);
    CHECK(inspect::environment(world).pieces().empty());
    for (const Vec2 p : before) {  // The same spots are stood on, by whomever.
        double nearest = 1e9;
        for (const Vec2 q : world.characters().position) nearest = std::min(nearest, distance(p, q));
        CHECK(nearest < 0.1);
    }
}

TEST_CASE("an obstacle moved to and fro: nobody is ever in it") {
    World world = World::create(openFloor(25)).value();
    REQUIRE(give(world, putThing(tree({-6, 5}, 0.7))).ok());
    runSteps(world, 1);
    const ObstacleId id = world.obstacleIds()[0];
    for (int k = 0; k < 60; ++k) {
        REQUIRE(give(world, putThing(tree({-6.0, 5.0 - 0.1 * k}, 0.7), id)).ok());
        runSteps(world, 3);  // At 2 m/s.
        CHECK(world.rejections().empty());
        CHECK(freeDistance(world) > 0.2);
    }
    runSteps(world, 300);
    CHECK(freeDistance(world) > 0.25 - 1e-6);
    CHECK(inspect::environment(world).obstacle(id)->centre == Vec2{-6.0, 5.0 - 0.1 * 59});
}

TEST_CASE("a wall across the path is walked round as soon as it stands, and not when it is gone") {
    const auto farthest = [](bool wall, bool taken) {
        World world = World::create(openFloor(9)).value();
        if (wall) REQUIRE(give(world, putThing(block(-1, -3, 0, 12))).ok());
        REQUIRE(give(world, SetPose{world.group(0).id, {6, 3}, 0}).ok());
        runSteps(world, 5);
        if (taken) REQUIRE(give(world, removeThing(world.obstacleIds()[0])).ok());
        double low = 0.0;
        for (int s = 0; s < 20 * 60; ++s) {
            world.step();
            for (const Vec2 p : world.characters().position) low = std::min(low, p.y);
        }
        CHECK(worstToPlace(world) < 0.2);
        CHECK(distance(world.group(0).pose.position, {6, 3}) < 0.5);
        return low;
    };
    const double open = farthest(false, false);
    CHECK(farthest(true, false) < -3.0);
    CHECK(farthest(true, true) > open - 1.0);
}

TEST_CASE(
    "a patch laid under a standing crowd is entered at once, moved it is left, and removed it is gone") {
    World world = World::create(openFloor(16)).value();
    runSteps(world, 10);
    const auto count = [&](int steps, EventKind kind) {
        int n = 0;
        for (int s = 0; s < steps; ++s) {
            world.step();
            for (const Event& event : world.events()) n += event.kind == kind;
        }
        return n;
    };
    REQUIRE(give(world, putThing(rectangle(-11, -5, -1, 5, 3))).ok());
    CHECK(count(120, EventKind::EnterPatch) == 16);
    const PatchId id = world.patchIds()[0];
    for (std::size_t i = 0; i < 16; ++i) {
        CHECK(world.characters().patch[i] == id.value);
        CHECK(world.characters().motion[i] == 3);
    }
    REQUIRE(give(world, putThing(rectangle(3, -5, 9, 5, 3), id)).ok());
    CHECK(count(120, EventKind::LeavePatch) == 16);
    for (std::size_t i = 0; i < 16; ++i) CHECK(world.characters().patch[i] == 0);
    REQUIRE(give(world, putThing(rectangle(-11, -5, -1, 5, 1), id)).ok());
    CHECK(count(120, EventKind::EnterPatch) == 16);
    CHECK(world.characters().motion[0] == 1);
    REQUIRE(give(world, removeThing(id)).ok());
    CHECK(count(120, EventKind::LeavePatch) == 16);
    for (std::size_t i = 0; i < 16; ++i) CHECK(world.characters().motion[i] == 0);
    CHECK(world.patchIds().empty());
    CHECK(worstToPlace(world) < 0.05);  // None of this moved anybody.
}

TEST_CASE("ids of what is gone are not given again, and commands for it are refused") {
    World world = World::create(openFloor(4)).value();
    REQUIRE(give(world, putThing(tree({5, 5}, 0.5))).ok());
    REQUIRE(give(world, putThing(rectangle(2, 2, 4, 4, 3))).ok());
    runSteps(world, 1);
    const ObstacleId obstacle = world.obstacleIds()[0];
    const PatchId patch = world.patchIds()[0];
    REQUIRE(give(world, removeThing(obstacle)).ok());
    REQUIRE(give(world, removeThing(patch)).ok());
    REQUIRE(give(world, putThing(tree({5, 5}, 0.5))).ok());
    REQUIRE(give(world, putThing(rectangle(2, 2, 4, 4, 3))).ok());
    REQUIRE(give(world, putThing(tree({1, 1}, 0.5), obstacle)).ok());
    REQUIRE(give(world, putThing(rectangle(0, 0, 1, 1, 3), patch)).ok());
    runSteps(world, 1);
    CHECK(world.obstacleIds()[0] > obstacle);
    CHECK(world.patchIds()[0] > patch);
    REQUIRE(world.rejections().size() == 2);
    for (const Rejection& rejection : world.rejections())
        CHECK(rejection.status.code() == StatusCode::NotFound);
    CHECK(inspect::environment(world).obstacle(world.obstacleIds()[0])->centre == Vec2{5, 5});
}

TEST_CASE("a car on its path touches nobody who can step out of its path") {
    WorldDef def = openFloor(9);
    def.groups[0].position = {0, 0};
    def.groups[0].formation.spacing = 1.2;
    ObstacleDef car = tree({-10, 0}, 0.6);
    car.path.waypoints = {{0, {0, 0}, 0}, {20, {20, 0}, 0}};  // 1 m/s, straight through them.
    def.obstacles.push_back(car);
    World world = World::create(def).value();
    double least = 1e9;
    for (int s = 0; s < 22 * 60; ++s) {
        world.step();
        least = std::min(least, freeDistance(world));
        CHECK(world.contacts().worstPenetration < 0.05);
    }
    CHECK(least > 0.25 - 1e-3);  // Their radius.
    runSteps(world, 300);
    CHECK(worstToPlace(world) < 0.1);
    CHECK(matched(world) == 9);
}

TEST_CASE("with a quick car crossing in front, walkers keep clear of it and all arrive") {
    WorldDef def = openFloor(9);
    ObstacleDef car = tree({0, -9}, 0.6);
    car.path.waypoints = {
        {0, {0, 0}, 0}, {6, {0, 18}, 0}, {12, {0, 0}, 0}};  // 3 m/s: faster than they runSteps.
    car.path.loop = true;
    def.obstacles.push_back(car);
    World world = World::create(def).value();
    REQUIRE(give(world, SetPose{world.group(0).id, {6, 0}, 0}).ok());
    double least = 1e9;
    for (int s = 0; s < 20 * 60; ++s) {
        world.step();
        least = std::min(least, freeDistance(world));
    }
    CHECK(least > 0.0);
    CHECK(worstToPlace(world) < 0.2);
    for (const Vec2 p : world.characters().position) CHECK(p.x > 3.0);
}

TEST_CASE("time.step stands, other parameters take hold in the step of their command") {
    World world = World::create(openFloor(9)).value();
    const Status refused = give(world, SetParameter{"time.step", 0.02});
    CHECK_FALSE(refused.ok());
    CHECK(refused.message().find("time.step") != std::string::npos);
    REQUIRE(give(world, SetParameter{"character.maxSpeed", 0.5}).ok());
    REQUIRE(give(world, SetPose{world.group(0).id, {6, 0}, 0}).ok());
    world.step();
    CHECK(world.parameters().stepTime == 1.0 / 60.0);
    CHECK(world.parameters().character.maxSpeed == 0.5);
    double fastest = 0.0;
    for (int s = 0; s < 120; ++s) {
        world.step();
        for (const Vec2 v : world.characters().velocity) fastest = std::max(fastest, length(v));
    }
    CHECK(fastest <= 0.5 + 1e-9);
    CHECK(fastest > 0.45);
}
