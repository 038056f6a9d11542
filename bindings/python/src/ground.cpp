// What lies on the ground of a world: muster.Obstacle, Patch, Item, FormationCheckpoint, Area.
#include "array_view.h"
#include "python_world.h"
#include "to_python.h"

namespace muster::python {
namespace {

/// A class of muster.records, which are plain data.
py::object groundClass(const char* name) {
    return py::module_::import("muster.records").attr(name);
}

}  // namespace

py::list obstaclesOf(const py::object& object) {
    const World& world = worldOf(object);
    const py::object type = groundClass("Obstacle");
    py::list all;
    for (const ObstacleId id : world.obstacleIds()) {
        const ObstacleView view = world.obstacle(id);
        all.append(type(id.value, toPython(view.def), pointArray(view.outline), toPython(view.centre)));
    }
    return all;
}

py::list patchesOf(const py::object& object) {
    const World& world = worldOf(object);
    const py::object type = groundClass("Patch");
    py::list all;
    for (const PatchId id : world.patchIds()) {
        const PatchView view = world.patch(id);
        all.append(type(id.value, toPython(view.def), pointArray(view.outline)));
    }
    return all;
}

py::list itemsOf(const py::object& object) {
    const World& world = worldOf(object);
    const py::object type = groundClass("Item");
    py::list all;
    for (std::size_t i = 0; i < world.items().size(); ++i)
        all.append(type(world.itemIds()[i].value, toPython(world.items()[i]), world.collected()[i] != 0));
    return all;
}

py::list checkpointsOf(const py::object& object) {
    const World& world = worldOf(object);
    const py::object type = groundClass("FormationCheckpoint");
    py::list all;
    for (std::size_t i = 0; i < world.checkpoints().size(); ++i)
        all.append(type(world.checkpointIds()[i].value, toPython(world.checkpoints()[i]),
                        world.checkpointGroups()[i].value));
    return all;
}

py::list areasOf(const py::object& object) {
    const World& world = worldOf(object);
    const py::object type = groundClass("Area");
    py::list all;
    for (std::size_t i = 0; i < world.areaCount(); ++i) {
        const AreaView view = world.area(i);
        all.append(
            type(view.id.value, toPython(view.def), view.group.value, view.count.passed, view.count.waiting));
    }
    return all;
}

}  // namespace muster::python
