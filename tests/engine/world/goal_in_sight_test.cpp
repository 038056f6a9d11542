// Nobody walks far round through a passage to a place that it sees.
#include <doctest.h>

#include "engine/world/dragged_scenes.h"
#include "engine/world/world_engine.h"

using namespace muster;
using namespace muster::testing;

namespace {

// True for one on its way to a passage, although the straight line to its goal is clear and much shorter. Its
// place may still travel there.
bool goesRound(const WorldState& state, std::int32_t i) {
    const Characters& c = state.characters;
    if (c.chosen[i].way < 0 || c.place[i] < 0) return false;
    const Vec2 goal = state.groups[c.group[i]].places.reachableTargets()[c.place[i]];
    return c.cost[i] > 3.0 * distance(c.position[i], goal) + 6.0 &&
           state.environment.clearLine(c.position[i], goal, state.parameters.character.radius);
}

}  // namespace

TEST_CASE("who sees its place does not go round through a passage") {
    DraggedScene scene(SceneFamily::Crossing, 45);
    World world = World::create(scene.def()).value();
    const WorldState& state = WorldAccess::of(world).state;
    std::vector<int> steps(state.characters.size(), 0);
    int longest = 0;
    bool anyWay = false;
    while (world.time() < DraggedScene::end() + 35.0) {
        scene.act(world);
        world.step();
        for (std::int32_t i = 0; i < std::ssize(steps); ++i) {
            anyWay = anyWay || state.characters.chosen[i].way >= 0;
            steps[i] = goesRound(state, i) ? steps[i] + 1 : 0;
            longest = std::max(longest, steps[i]);
        }
    }
    CHECK(anyWay);
    // Ways are chosen twice a second, and who is let through within a second does not turn back.
    CHECK(longest <= 90);
}
