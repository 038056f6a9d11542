// muster.Group
#include <cmath>
#include <string>

#include "array_view.h"
#include "from_python.h"
#include "to_python.h"
#include "world_handle.h"

namespace muster::python {
namespace {

/// A group of a world, by its id.
struct GroupHandle {
    py::object world;
    GroupId id;
};

/// The index of the group of an id; throws where there is none.
std::size_t indexOf(const World& world, GroupId id) {
    std::size_t low = 0;
    std::size_t high = world.groupCount();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        (world.group(middle).id < id ? low : high) = world.group(middle).id < id ? middle + 1 : middle;
    }
    if (low == world.groupCount() || world.group(low).id != id)
        check({StatusCode::NotFound,
               "group: found " + std::to_string(id.value) + ", expected the id of one of the world"});
    return low;
}

GroupView read(const GroupHandle& group) {
    const World& world = worldOf(group.world);
    return world.group(indexOf(world, group.id));
}

template <class T>
void defineArray(py::class_<GroupHandle>& type, const char* name, std::span<const T> GroupView::*array,
                 const char* doc) {
    type.def_property_readonly(
        name, [array](const GroupHandle& self) { return viewOf(self.world, read(self).*array); }, doc);
}
template <class T>
void defineList(py::class_<GroupHandle>& type, const char* name, std::span<const T> GroupView::*array,
                const char* doc) {
    type.def_property_readonly(
        name, [array](const GroupHandle& self) { return listOf(read(self).*array); }, doc);
}
template <class T>
void defineValue(py::class_<GroupHandle>& type, const char* name, T GroupView::*value, const char* doc) {
    type.def_property_readonly(
        name, [value](const GroupHandle& self) { return toPython(read(self).*value); }, doc);
}

void defineArrays(py::class_<GroupHandle>& type) {
    using View = GroupView;
    defineArray(type, "members", &View::members, "Indices of its characters, ascending. Shape (n,), int32.");
    defineArray(type, "rest_mesh", &View::restMesh,
                "Vertices of the rest shape, in the group's axes [m]. Shape (v, 2), float64.");
    defineArray(type, "user_mesh", &View::userMesh,
                "Vertices of Vu, deformed by controls [m]. Shape (v, 2), float64.");
    defineArray(type, "final_mesh", &View::finalMesh,
                "Vertices of Vf: Vu deformed by the environment [m]. Shape (v, 2), float64.");
    defineArray(type, "triangles", &View::triangles,
                "Vertex indices, counter-clockwise. Shape (t, 3), int32.");
    defineArray(type, "mesh_places", &View::meshPlaces,
                "Each place as a point of the mesh. Shape (n,), records of triangle and weight (3).");
    defineArray(type, "place_positions", &View::placePositions,
                "Position of each place [m]. Shape (n, 2), float64.");
    defineArray(type, "place_velocities", &View::placeVelocities,
                "Velocity of each place [m/s]. Shape (n, 2), float64.");
    defineArray(type, "place_targets", &View::placeTargets,
                "Reachable target of each place [m]. Shape (n, 2), float64.");
    defineArray(type, "place_usable", &View::placeUsable,
                "1 where a character can stand at the place, else 0. Shape (n,), uint8.");
    defineArray(type, "place_classes", &View::placeClasses,
                "Class of each place by the group's roles, 0 for whoever is left. Shape (n,), uint8; empty "
                "without roles.");
    defineArray(
        type, "way", &View::way,
        "What is ahead of the way of its order: corners [m], the next one first. Shape (c, 2), float64.");
}

void defineValues(py::class_<GroupHandle>& type) {
    using View = GroupView;
    type.def_property_readonly(
        "id", [](const GroupHandle& self) { return self.id.value; }, "Unique id, never used again.");
    type.def_property_readonly(
        "name", [](const GroupHandle& self) { return std::string(read(self).name); }, "Name for display.");
    defineValue(type, "colour", &View::colour, "Chosen colour, 0xRRGGBB; None for the palette's.");
    defineValue(type, "build", &View::build, "Build of its drawn bodies; None for both.");
    defineValue(type, "motions", &View::motions, "How it walks and jogs; None for the plain manner.");
    defineValue(type, "count", &View::count, "Number of characters and of places.");
    defineValue(type, "formation", &View::formation, "Current shape; `definition` has the whole of it.");
    defineValue(type, "formation_version", &View::formationVersion,
                "Increases whenever the mesh is replaced.");
    type.def_property_readonly(
        "position", [](const GroupHandle& self) { return toPython(read(self).pose.position); },
        "Centre of the rest mesh in the world (x, y) [m].");
    type.def_property_readonly(
        "angle",
        [](const GroupHandle& self) {
            const Rotation turn = read(self).pose.rotation;
            return std::atan2(turn.s, turn.c);
        },
        "Heading of the rest mesh, counter-clockwise from +x [rad], -pi to pi.");
    defineValue(type, "objective", &View::objective, "Objective of the last plan [cost^p].");
    defineValue(type, "gap_bound", &View::gapBound, "Upper bound of its duality gap [cost^p].");
    defineValue(type, "walk", &View::walk, "Path costs by the last plan.");
    defineValue(type, "mean_lag", &View::meanLag,
                "Mean distance of characters to the targets of their places [m].");
    defineValue(type, "held", &View::held, "True: it waits, and its orders stay.");
    defineValue(type, "patrols", &View::patrols, "True: orders that are done come last again.");
    defineValue(type, "conduct", &View::conduct, "How it behaves.");
}

}  // namespace

py::list groupsOf(const py::object& object) {
    const World& world = worldOf(object);
    py::list all;
    for (std::size_t i = 0; i < world.groupCount(); ++i) all.append(GroupHandle{object, world.group(i).id});
    return all;
}

py::object groupOf(const py::object& world, const py::object& given) {
    const auto id = fromPython<std::uint32_t>(given, "group");
    (void)indexOf(worldOf(world), {id});
    return py::cast(GroupHandle{world, {id}});
}

void defineGroups(py::module_& module) {
    py::class_<GroupHandle> type(
        module, "Group",
        "A group of a world. What is read is what it is now; every attribute fails with NotFoundError\n"
        "once the group has ended. Arrays are the engine's own, as those of Characters.");
    defineValues(type);
    defineArrays(type);
    defineList(type, "controls", &GroupView::controls,
               "Controls in the order of creation, which is that of ids.");
    defineList(type, "orders", &GroupView::orders, "Its queue of orders; the first one is carried out.");
    type.def_property_readonly(
        "definition",
        [](const GroupHandle& self) {
            const World& world = worldOf(self.world);
            return toPython(world.groupDef(indexOf(world, self.id)));
        },
        "Current name, count and formation, as a GroupDef.");
    type.def("__repr__", [](const GroupHandle& self) {
        const GroupView view = read(self);
        return "<muster.Group " + std::to_string(self.id.value) + " \"" + std::string(view.name) +
               "\": " + std::to_string(view.count) + " characters>";
    });
}

}  // namespace muster::python
