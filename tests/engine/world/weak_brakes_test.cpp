// Bodies that brake weakly: they see each other in time, and come to their places without going too far.
#include <doctest.h>

#include "engine/world/turned.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// As many ships at each end of 80 m of open water as change sides.
WorldDef shipsThatMeet(std::int32_t count) {
    WorldDef def{.box = {{-60, -40}, {60, 40}}};
    for (const double side : {-1.0, 1.0})
        def.groups.push_back({.count = count,
                              .formation = {.spacing = 6.0},
                              .position = {40 * side, 0},
                              .angle = side < 0.0 ? 0.0 : 3.141592653589793,
                              .bodies = {{.radius = 1.5, .maxSpeed = 3.0, .acceleration = 0.3, .mass = 50.0}},
                              .orders = {Order::move({-40 * side, 0})}});
    return def;
}

/// Seconds until the last ship is within 0.5 m of its place for good, and how far any went beyond `x` = 40.
struct ShipsPlayed {
    double last = 0.0, beyond = 0.0;
};

ShipsPlayed playShips(std::int32_t count, const Lie& lie, double seconds) {
    World world = World::create(turned(shipsThatMeet(count), lie)).value();
    ShipsPlayed played;
    while (world.time() < seconds) {
        world.step();
        if (worstToPlace(world) > 0.5 || distance(middleOf(world), lie({40, 0})) > 2.0)
            played.last = world.time();
        for (const Vec2 p : world.characters().position)
            played.beyond = std::max(played.beyond, std::fabs(lie.back(p).x) - 40.0);
    }
    return played;
}

}  // namespace

TEST_CASE("ships with weak brakes that meet pass each other, and do not go beyond their places") {
    for (const Lie& lie : kLies) {
        const ShipsPlayed one = playShips(1, lie, 60.0);
        INFO("turned by " << lie.angle << ": " << one.last << " s, " << one.beyond << " m too far");
        CHECK(one.last < 48.0);
        CHECK(one.beyond < 0.5);
    }
    for (const Lie& lie : kLies) {
        const ShipsPlayed fleet = playShips(9, lie, 80.0);
        INFO("nine, turned by " << lie.angle << ": " << fleet.last << " s");
        CHECK(fleet.last < 70.0);
    }
}
