// Marches know how slow the ground is: they go round where that is sooner, and through where it is not.
#include <doctest.h>

#include "engine/world/turned.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// 30 people who are to go from the left to the right.
WorldDef overSlowGround(std::vector<PatchDef> patches) {
    WorldDef def = openFloor(30);
    def.box = {{-30, -25}, {30, 25}};
    def.groups[0].position = {-16, 0};
    def.patches = std::move(patches);
    return def;
}

PatchDef slowPatch(double x0, double y0, double x1, double y1, double speed) {
    PatchDef def = rectangle(x0, y0, x1, y1, 3);
    def.speed = speed;
    return def;
}

/// Seconds until all are within a metre of their places.
double secondsOver(const WorldDef& def, const Lie& lie, Manner manner) {
    World world = World::create(turned(def, lie)).value();
    Order order = Order::move(lie({16, 0}));
    order.manner = manner;
    REQUIRE(world.submit({0, 1, 0, GiveOrder{world.group(0).id, QueueMode::Replace, 0, order}}).ok());
    const auto isThere = [&] {
        return distance(middleOf(world), lie({16, 0})) < 2.0 && worstToPlace(world) < 1.0;
    };
    while (world.time() < 100.0 && !isThere()) world.step();
    return world.time();
}

}  // namespace

TEST_CASE("a march goes round slow ground where that is sooner, as each for itself does") {
    struct Scene {
        std::string name;
        std::vector<PatchDef> patches;
        double bound = 1.3;  // Times each for itself.
    };
    const Scene scenes[] = {
        {"a tenth of the speed", {slowPatch(-4, -14, 4, 14, 0.1)}},
        {"a quarter of the speed", {slowPatch(-4, -14, 4, 14, 0.25)}},
        {"two, one behind the other", {slowPatch(-8, -20, -3, 4, 0.2), slowPatch(3, -4, 8, 20, 0.2)}, 1.6},
        {"a dry way between two", {slowPatch(-5, -25, 5, 3, 0.1), slowPatch(-5, 12, 5, 25, 0.1)}},
    };
    for (const Scene& scene : scenes)
        for (const Lie& lie : kLies) {
            const WorldDef def = overSlowGround(scene.patches);
            const double march = secondsOver(def, lie, Manner::March);
            const double free = secondsOver(def, lie, Manner::Free);
            INFO(scene.name << ", turned by " << lie.angle << ": " << march << " s, each for itself "
                            << free);
            CHECK(march < scene.bound * free);
        }
}

TEST_CASE("a march goes through slow ground where the way round takes longer") {
    for (const Lie& lie : kLies) {
        const double march = secondsOver(overSlowGround({slowPatch(-2, -20, 2, 20, 0.5)}), lie,
                                         Manner::March);
        INFO("turned by " << lie.angle << ": " << march << " s");
        CHECK(march < 22.0);
    }
}
