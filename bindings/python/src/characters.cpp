// muster.Characters
#include "array_view.h"
#include "generated/view_properties.h"
#include "python_world.h"

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
    py::class_<Characters> type(module, "Characters",
                                "All characters of a world, one row each, in ascending order of ids.\n\n"
                                "Every attribute is the engine's own array, read-only and without a copy. It "
                                "shows the present until the world steps\n"
                                "or goes back; take it again then, or copy() what is to stay.");
    eachColumn([&](const char* name, auto array, const char* doc) { defineArray(type, name, array, doc); });
    type.def("__len__", [](const Characters& self) { return worldOf(self.world).characters().size(); });
}

}  // namespace muster::python
