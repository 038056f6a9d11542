// The module muster._core: what muster (../muster) is made of.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "pinned_memory.h"
#include "python_world.h"
#include "status_error.h"
#include "to_python.h"

PYBIND11_MODULE(_core, module) {
    using namespace muster::python;
    registerErrors();
    module.attr("VERSION") = MUSTER_VERSION;
    defineCharacters(module);
    defineGroups(module);
    defineWorld(module);
    defineScenarios(module);
    defineTakes(module);
    defineMeasures(module);
    defineFigures(module);
    defineMotion(module);
    module.def("engine_defaults", &engineDefaults,
               "For tests: every type of plain data as the engine makes it, by name.");
    module.def("kept_blocks", &keptBlocks,
               "For tests: arrays that the engine has given back while views lie in them.");
}
