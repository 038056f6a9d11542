// muster.RunMetrics
#include "engine/world/metrics.h"
#include "python_world.h"
#include "to_python.h"

namespace muster::python {
namespace {

/// The metrics of a world, which they keep.
struct WorldMetrics {
    explicit WorldMetrics(py::object watched) : world(std::move(watched)), metrics(worldOf(world)) {}

    py::object world;
    RunMetrics metrics;
};

}  // namespace

void defineFigures(py::module_& module) {
    py::class_<WorldMetrics>(
        module, "RunMetrics",
        "Watches a world from its first step on and gives the figures that `muster play` prints.")
        .def(py::init([](const py::object& world) {
                 (void)py::cast<WorldHandle&>(world);
                 return std::make_unique<WorldMetrics>(world);
             }),
             py::arg("world"), "Starts watching; before the first step.")
        .def(
            "observe", [](WorldMetrics& self) { self.metrics.observe(worldOf(self.world)); },
            "Call after every single step.")
        .def(
            "settled", [](const WorldMetrics& self) { return self.metrics.settled(worldOf(self.world)); },
            "True where nothing is left to do: no control still moves, places stand, all have arrived or "
            "left, no "
            "group has further orders, and no source may still send anybody.")
        .def(
            "figures",
            [](const WorldMetrics& self, bool pathRatio) {
                return toPython(self.metrics.figures(worldOf(self.world), pathRatio));
            },
            py::arg("path_ratio") = false,
            "The figures so far. `path_ratio` needs one cost field per place: seconds for large crowds.");
}

}  // namespace muster::python
