// Once memory has grown, steps without an order allocate nothing, in any scene of the benchmark whose world
// is made by the program.
#include <doctest.h>

#include "counting_new.h"
#include "muster/world.h"
#include "scale/crowd_scenes.h"

using namespace muster;
using namespace muster::scale;

namespace {

/// Allocations of 180 steps of a crowd on its way to a far formation, after 120 steps.
long onTheWay(const SceneDef& def) {
    const Scene scene = makeScene(def).value();
    World world = World::create(scene.world).value();
    for (int s = 0; s < 120; ++s) world.step();
    const long before = allocations;
    for (int s = 0; s < 180; ++s) world.step();
    return allocations - before;
}

}  // namespace

TEST_CASE("a crowd on its way to a far formation allocates nothing") {
    for (const std::string& name : sceneNames()) {
        if (name == "city") continue;  // Its map is no part of the project.
        CAPTURE(name);
        CHECK(onTheWay({name, Regime::Far, 160, 1, ""}) == 0);
    }
}
