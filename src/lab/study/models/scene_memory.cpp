#include "lab/study/models/scene_memory.h"

#include <algorithm>

namespace muster {
namespace {

// Whether a way or a point is shown that the formation has still to get to.
bool hasWay(const GroupView& group) {
    if (!group.orders.empty()) return true;
    return std::any_of(group.controls.begin(), group.controls.end(), [](const Control& control) {
        return std::any_of(control.points.begin(), control.points.end(),
                           [](const ControlPoint& p) { return p.trajectory.size() > 1; });
    });
}

constexpr std::uint32_t kLookSteps = 3;  // Number of steps between two pictures that are looked at.
constexpr std::size_t kMostScenes = 60;  // Number of pictures that are remembered, those of three seconds.

}  // namespace

void SceneMemory::look(const Trial& trial) {
    const World& world = trial.world();
    if (world.stepCount() % kLookSteps != 0) return;
    SeenScene scene;
    if (scenes_.size() >= kMostScenes) {
        scene = std::move(scenes_.front());
        scenes_.pop_front();
    }
    const CharactersView view = world.characters();
    scene.time = world.time();
    scene.positions.assign(view.position.begin(), view.position.end());
    scene.ids.assign(view.id.begin(), view.id.end());
    scene.groups.clear();
    for (const std::uint32_t index : view.group) scene.groups.push_back(world.group(index).id.value);
    scene.busy.clear();
    for (std::size_t g = 0; g < world.groupCount(); ++g)
        if (hasWay(world.group(g))) scene.busy.push_back(world.group(g).id.value);
    scene.collected.assign(world.collected().begin(), world.collected().end());
    scene.selected = trial.scheme().marks().selected;
    scenes_.push_back(std::move(scene));
}

const SeenScene& SceneMemory::at(double time) const {
    const SeenScene* found = &scenes_.front();
    for (const SeenScene& scene : scenes_)
        if (scene.time <= time) found = &scene;
    return *found;
}

}  // namespace muster
