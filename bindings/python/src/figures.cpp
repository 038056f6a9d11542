// muster.RunMetrics
#include "to_python.h"
#include "world/metrics.h"
#include "world_handle.h"

namespace muster::python {

void defineFigures(py::module_& module) {
    py::class_<RunMetrics>(
        module, "RunMetrics",
        "Watches a world from its first step on and gives the figures that `muster play` prints.")
        .def(py::init([](WorldHandle& world) { return RunMetrics(world.get()); }), py::arg("world"),
             "Starts watching; before the first step.")
        .def(
            "observe", [](RunMetrics& self, WorldHandle& world) { self.observe(world.get()); },
            py::arg("world"), "Call after every single step.")
        .def(
            "settled", [](const RunMetrics& self, WorldHandle& world) { return self.settled(world.get()); },
            py::arg("world"),
            "True where nothing is left to do: no control still moves, places stand, and all have arrived.")
        .def(
            "figures",
            [](const RunMetrics& self, WorldHandle& world, bool pathRatio) {
                return toPython(self.figures(world.get(), pathRatio));
            },
            py::arg("world"), py::arg("path_ratio") = false,
            "The figures so far. `path_ratio` needs one cost field per place: seconds for large crowds.");
}

}  // namespace muster::python
