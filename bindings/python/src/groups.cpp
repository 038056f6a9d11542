// muster.Group
#include <cmath>
#include <string>

#include "array_view.h"
#include "from_python.h"
#include "generated/view_properties.h"
#include "python_world.h"
#include "to_python.h"

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

/// What Python has in a form of its own.
void defineOwn(py::class_<GroupHandle>& type) {
    type.def_property_readonly(
        "id", [](const GroupHandle& self) { return self.id.value; }, "Unique id, never used again.");
    type.def_property_readonly(
        "name", [](const GroupHandle& self) { return std::string(read(self).name); }, "Name for display.");
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
    defineOwn(type);
    eachValue([&](const char* name, auto value, const char* doc) { defineValue(type, name, value, doc); });
    eachArray([&](const char* name, auto array, const char* doc) { defineArray(type, name, array, doc); });
    eachList([&](const char* name, auto list, const char* doc) { defineList(type, name, list, doc); });
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
