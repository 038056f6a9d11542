// A car driven through a crowd harms nobody: people give way in time and come back.
#include <doctest.h>

#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/ground/environment/obstacle_piece.h"
#include "engine/world/inspect.h"
#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A car of 4.2 m by 1.8 m that drives along y = `lane` from the left to the right of the world.
ObstacleDef car(double speed, double lane) {
    ObstacleDef def = block(-2.1, -0.9, 2.1, 0.9);
    def.path.waypoints = {
        {0.0, {-24, lane}, 0.0}, {1.0, {-24, lane}, 0.0}, {1.0 + 48.0 / speed, {24, lane}, 0.0}};
    return def;
}

/// The least gap between people and the car while that drives.
double leastGap(const World& world) {
    double least = 1e9;
    for (const ObstaclePiece& piece : inspect::environment(world).pieces())
        for (const Vec2 p : world.characters().position)
            if (!(piece.velocity == Vec2{}))
                least = std::min(least, piece.signedDistance(p) - world.parameters().character.radius);
    return least;
}

void driveThrough(std::int32_t count, double spacing, double speed, std::uint64_t seed) {
    CAPTURE(count);
    CAPTURE(speed);
    CAPTURE(seed);
    WorldDef def{.box = {{-28, -16}, {28, 16}}, .seed = seed};
    def.groups.push_back({.count = count, .formation = {.spacing = spacing}, .jitter = 0.15});
    Random random(seed);
    def.obstacles.push_back(car(speed, random.uniform(-2.0, 2.0)));
    World world = World::create(def).value();
    RunMetrics metrics(world);
    double least = 1e9;
    while (world.time() < 48.0 / speed + 35.0) {
        world.step();
        metrics.observe(world);
        least = std::min(least, leastGap(world));
        if (world.time() > 48.0 / speed + 1.0 && world.stepCount() % 30 == 0 && metrics.settled(world)) break;
    }
    CHECK(least > 0.0);
    CHECK(metrics.figures(world, false).topSpeedRatio < 1.05);
    CHECK(metrics.figures(world, false).overlapPairsMax == 0);
    CHECK(metrics.notArrived(world) == 0);
}

}  // namespace

TEST_CASE("a car driven through the middle of a crowd touches nobody") {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        for (const double speed : {2.0, 5.0}) {
            driveThrough(36, 1.0, speed, seed);
            driveThrough(100, 0.8, speed, seed);
        }
    }
}
