// Long ways and ways that do not exist: everybody arrives, or stands at the nearest ground.
#include <doctest.h>

#include "base/maths.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef floorOf(double side, std::int32_t count, Vec2 position) {
    return {.box = {{-side / 2, -side / 2}, {side / 2, side / 2}},
            .groups = {{.count = count, .position = position}}};
}

void setOff(World& world, Vec2 p) {
    REQUIRE(give(world, SetPose{world.group(0).id, p, 0.0}).ok());
}

double farthestFromPlace(const World& world) {
    double farthest = 0.0;
    const auto& places = inspect::places(world, 0).reachableTargets();
    for (std::size_t i = 0; i < world.characters().position.size(); ++i) {
        const std::int32_t place = world.characters().place[i];
        farthest = std::max(farthest,
                            place < 0 ? 1e9 : distance(world.characters().position[i], places[place]));
    }
    return farthest;
}

}  // namespace

TEST_CASE("a crowd arrives round a long wall whose gap is at its end, about as soon as the way allows") {
    // 400 x 400 cells; today's far fields end long before.
    WorldDef def = floorOf(100.0, 40, {-24, -30});
    def.obstacles = {block(-0.5, -50, 0.5, 46)};
    World world = World::create(def).value();
    setOff(world, {24, -30});
    const Vec2 corner{0, 46.25};
    const double bound = (distance({-24, -30}, corner) + distance(corner, {24, -30})) /
                         def.parameters.character.maxSpeed;
    while (world.time() < 1.1 * bound && farthestFromPlace(world) > 0.5) world.step();
    CHECK(farthestFromPlace(world) <= 0.5);
    CHECK(world.time() > 0.95 * bound);
}

TEST_CASE("before a river that nobody can cross the formation stands whole on the bank, facing its goal") {
    WorldDef def = floorOf(60.0, 100, {-20, 5});
    def.obstacles = {block(-3, -30, 3, 30)};
    World world = World::create(def).value();
    setOff(world, {20, 5});
    int noPath = 0;
    for (int s = 0; s < 20 * 60; ++s) {
        world.step();
        for (const Event& event : world.events()) noPath += event.kind == EventKind::NoPath ? 1 : 0;
    }
    CHECK(noPath == 1);
    CHECK(farthestFromPlace(world) < 0.1);
    const PlaceTracker& places = inspect::places(world, 0);
    double nearest = -1e9;
    for (std::size_t k = 0; k < places.positions().size(); ++k) {
        CHECK(places.fit()[k] == 1);
        // All are moved alike, so that the formation keeps its shape.
        CHECK(distance(places.positions()[k] - places.targets()[k],
                       places.positions()[0] - places.targets()[0]) < 0.1);
        nearest = std::max(nearest, places.positions()[k].x);
    }
    CHECK(nearest > -3.8);
    CHECK(nearest < -3.2);
}

TEST_CASE("routes are a cache: a world restored on its way goes on to the same bits") {
    Random random(3);
    WorldDef def = floorOf(90.0, 30, {-38, -38});
    for (int k = 0; k < 60; ++k) {
        const double x = random.uniform(-30, 30), y = random.uniform(-30, 30);
        def.obstacles.push_back(block(x, y, x + random.uniform(1, 8), y + random.uniform(1, 8)));
    }
    ObstacleDef car = tree({-20, -20}, 1.5);
    car.path.waypoints = {{0, {0, 0}, 0}, {8, {25, 25}, 0}, {16, {0, 0}, 0}};
    car.path.loop = true;
    def.obstacles.push_back(car);
    World world = World::create(def).value();
    setOff(world, {38, 38});
    for (int s = 0; s < 20; ++s) world.step();
    World copy = World::restore(world.snapshot()).value();
    for (int s = 0; s < 900; ++s) {
        if (s % 150 == 77) copy = World::restore(copy.snapshot()).value();
        if (s == 300)
            for (World* each : {&world, &copy}) REQUIRE(give(*each, putThing(block(10, -5, 14, 30))).ok());
        world.step();
        copy.step();
        REQUIRE(world.hash() == copy.hash());
    }
}
