// muster.Characters
#include "array_view.h"
#include "world_handle.h"

namespace muster::python {
namespace {

/// The characters of a world.
struct Characters {
    py::object world;
};

template <class T>
void defineArray(py::class_<Characters>& type, const char* name, std::span<const T> CharactersView::*array,
                 const char* doc) {
    type.def_property_readonly(
        name,
        [array](const Characters& self) {
            return viewOf(self.world, worldOf(self.world).characters().*array);
        },
        doc);
}

}  // namespace

py::object charactersOf(const py::object& world) {
    (void)worldOf(world);
    return py::cast(Characters{world});
}

void defineCharacters(py::module_& module) {
    using View = CharactersView;
    py::class_<Characters> type(module, "Characters",
                                "All characters of a world, one row each, in ascending order of ids.\n\n"
                                "Every attribute is the engine's own array, read-only and without a copy. It "
                                "shows the present until the world steps\n"
                                "or goes back; take it again then, or copy() what is to stay.");
    defineArray(type, "id", &View::id, "Unique ids, never used again. Shape (n,), uint32.");
    defineArray(type, "group", &View::group, "Index into world.groups. Shape (n,), uint32.");
    defineArray(type, "position", &View::position, "Positions [m]. Shape (n, 2), float64.");
    defineArray(type, "velocity", &View::velocity, "Velocities [m/s]. Shape (n, 2), float64.");
    defineArray(type, "heading", &View::heading, "Unit vectors in which bodies face. Shape (n, 2), float64.");
    defineArray(type, "place", &View::place,
                "Index of the place in its group; -1 for the unmatched. Shape (n,), int32.");
    defineArray(type, "direction", &View::direction,
                "Unit vectors along planned paths; zero where there is no path. Shape (n, 2), float64.");
    defineArray(type, "cost", &View::cost,
                "Cost of the path to its place; infinite for the unmatched. Shape (n,), float64.");
    defineArray(type, "motion", &View::motion,
                "Motion it performs: an index into WorldDef.clips. Shape (n,), int32.");
    defineArray(type, "phase", &View::phase,
                "Phase of that motion: the index of a MotionPhase. Shape (n,), uint8.");
    defineArray(type, "motion_time", &View::motionTime,
                "Time since the phase began [s]. Shape (n,), float64.");
    defineArray(type, "patch", &View::patch,
                "Id of the patch that it is in; 0 for none. Shape (n,), uint32.");
    defineArray(type, "body", &View::body,
                "What it is. Shape (n,), records with the fields of Body: radius [m], max_speed [m/s], "
                "acceleration [m/s^2],\n"
                "mass, supply, unit_class, headway [s], premovement [s], upstairs, downstairs.");
    defineArray(type, "driver", &View::driver, "Who moves it: the index of a Driver. Shape (n,), uint8.");
    defineArray(type, "wanted_velocity", &View::wantedVelocity,
                "Velocity that steering aims at, before bounds and contacts [m/s]. Shape (n, 2), float64.");
    defineArray(type, "goal", &View::goal,
                "Id of the exit or waiting area that it goes to; 0 for none. Shape (n,), uint32.");
    type.def("__len__", [](const Characters& self) { return worldOf(self.world).characters().size(); });
}

}  // namespace muster::python
