// Exchanges of places while something is on the move: each must pay, so there are few.
#include <doctest.h>

#include "engine/world/scenes.h"
#include "engine/world/turned.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr std::int32_t kCrossing = 40;

/// People at the left who are to go to the right.
WorldDef crossingPeople() {
    WorldDef def = openFloor(kCrossing);
    def.box = {{-25, -20}, {25, 20}};
    def.groups[0].position = {-12, 0};
    def.groups[0].orders = {Order::move({12, 0})};
    return def;
}

/// A wall with a door of so many metres in which a gate moves along the wall by a path.
WorldDef movingGate(double width, double thickness, std::vector<Waypoint> path, bool loop) {
    WorldDef def = crossingPeople();
    const double w = 0.5 * width, t = 0.5 * thickness;
    def.obstacles = {block(-t, -20, t, -w), block(-t, w, t, 20), block(0.1 - t, -w - 0.1, t - 0.1, w + 0.1)};
    def.obstacles.back().path = {.waypoints = std::move(path), .loop = loop};
    return def;
}

/// A long body crosses the way up and down, again and again.
WorldDef trainAcross(double halfWidth, double period) {
    WorldDef def = crossingPeople();
    def.obstacles = {block(-halfWidth, -60, halfWidth, -40)};
    def.obstacles.back().path = {.waypoints = {{0, {}}, {period, {0, 120}}}, .loop = true};
    return def;
}

/// A bar of 6.4 m turns in a passage of 9 m.
WorldDef turningBar() {
    WorldDef def = crossingPeople();
    def.obstacles = {block(-3.5, -20, 3.5, -4.5), block(-3.5, 4.5, 3.5, 20), block(-3.2, -0.15, 3.2, 0.15)};
    def.obstacles.back().path = {.waypoints = {{0, {}, 0}, {12, {}, 6.283185307179586}}, .loop = true};
    return def;
}

struct MovingOutcome {
    std::size_t swaps = 0;
    std::size_t there = 0;
};

MovingOutcome playMoving(const WorldDef& def, const Lie& lie, double seconds) {
    World world = World::create(turned(def, lie)).value();
    MovingOutcome outcome;
    for (int s = 0; s < static_cast<int>(60 * seconds); ++s) {
        world.step();
        for (const Event& event : world.events()) outcome.swaps += event.kind == EventKind::Swap ? 1 : 0;
    }
    for (const Vec2 p : world.characters().position) outcome.there += lie.back(p).x > 5.0 ? 1 : 0;
    return outcome;
}

}  // namespace

TEST_CASE("while gates, trains and bars move people exchange few places, and all come through") {
    struct Scene {
        std::string name;
        WorldDef def;
        double seconds;
    };
    const Scene scenes[] = {
        {"a gate that opens after 15 s", movingGate(3, 1, {{0, {}}, {15, {}}, {18, {0, 3.2}}}, false), 35},
        {"a gate that opens and shuts",
         movingGate(3, 1, {{0, {}}, {2, {}}, {4, {0, 3.2}}, {7, {0, 3.2}}, {9, {}}}, true), 35},
        {"a train", trainAcross(1.5, 12), 25},
        {"a train that comes twice as often", trainAcross(1.5, 6), 25},
        {"a turnstile", turningBar(), 35},
    };
    for (const Scene& scene : scenes)
        for (const Lie& lie : kLies) {
            const MovingOutcome outcome = playMoving(scene.def, lie, scene.seconds);
            INFO(scene.name << ", turned by " << lie.angle << ": " << outcome.swaps << " exchanges");
            CHECK(outcome.there == kCrossing);
            CHECK(outcome.swaps < 10 * kCrossing);
        }
}
