// muster.World
#include "array_view.h"
#include "from_python.h"
#include "muster/parameter_table.h"
#include "python_world.h"
#include "to_python.h"

namespace muster::python {
namespace {

std::unique_ptr<WorldHandle> create(const py::object& definition, const py::object& workers) {
    const std::int32_t threads = threadsFrom(workers);
    const py::object given = py::module_::import("muster.scenario").attr("as_definition")(definition);
    const auto def = fromPython<WorldDef>(given, "definition");
    const py::gil_scoped_release others;
    return std::make_unique<WorldHandle>(take(World::create(def, threads)));
}

std::unique_ptr<WorldHandle> restore(const py::object& snapshot, const py::object& workers) {
    const std::int32_t threads = threadsFrom(workers);
    return std::make_unique<WorldHandle>(take(World::restore(bytesFrom(snapshot, "snapshot"), threads)));
}

py::bytes snapshotOf(const World& world) {
    const std::vector<std::uint8_t> bytes = world.snapshot();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

py::dict parametersOf(const World& world) {
    py::dict values;
    for (const ParameterInfo& info : parameterTable())
        values[py::str(std::string(info.name))] = info.get(world.parameters());
    return values;
}

py::list rejectionsOf(const World& world) {
    py::list all;
    for (const Rejection& rejection : world.rejections())
        all.append(py::module_::import("muster.records")
                       .attr("Rejection")(toPython(rejection.command), exceptionOf(rejection.status)));
    return all;
}

py::dict stageTimesOf(const World& world) {
    const StageTimes times = world.stageTimes();
    py::dict all = toPython(times.milliseconds);
    all["total"] = times.total;
    return all;
}

py::array wayAhead(const World& world, const py::object& character) {
    const auto id = fromPython<std::uint32_t>(character, "character");
    const std::span<const std::uint32_t> ids = world.characters().id;
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    if (at == ids.end() || *at != id)
        check({StatusCode::NotFound,
               "character: found " + std::to_string(id) + ", expected the id of one of the world"});
    return pointArray(world.wayAhead(static_cast<std::size_t>(at - ids.begin())));
}

py::object forecast(const py::object& self, const py::object& group, const py::object& order) {
    (void)groupOf(self, group);  // Fails where there is none.
    return toPython(worldOf(self).forecast({fromPython<std::uint32_t>(group, "group")},
                                           fromPython<Order>(order, "order")));
}

void defineState(py::class_<WorldHandle>& world) {
    world.def_property_readonly(
        "step_count", [](WorldHandle& self) { return self.get().stepCount(); }, "Number of steps done.");
    world.def_property_readonly(
        "time", [](WorldHandle& self) { return self.get().time(); },
        "Number of steps times the step time [s].");
    world.def_property_readonly(
        "parameters", [](WorldHandle& self) { return parametersOf(self.get()); },
        "All parameters by their names, as they are now; muster.parameter_table() describes them.");
    world.def(
        "hash", [](WorldHandle& self) { return self.get().hash(); },
        "Hash of all state, 64 bits: the same on every machine. The program prints it as f\"{hash:016x}\".");
    world.def(
        "snapshot", [](WorldHandle& self) { return snapshotOf(self.get()); },
        "All state as bytes, for restore() and rewind() with the same version of Muster.");
    world.def("rewind", &WorldHandle::rewind, py::arg("snapshot"),
              "Goes back to a snapshot of this world, or on to it. As restore(), but keeps what was computed "
              "and is still true.\n"
              "Fails with ParseError or UnsupportedError and then changes nothing.");
    world.def_static(
        "restore", &restore, py::arg("snapshot"), py::arg("threads") = 1,
        "A world from a snapshot; it continues bit for bit. Fails with ParseError on other bytes and with\n"
        "UnsupportedError on a snapshot of another version.");
}

void defineReadOuts(py::class_<WorldHandle>& world) {
    world.def_property_readonly("characters", &charactersOf,
                                "The characters of all groups: arrays without a copy.");
    world.def_property_readonly("groups", &groupsOf, "All groups, in ascending order of ids.");
    world.def("group", &groupOf, py::arg("id"), "The group of an id. Fails with NotFoundError.");
    world.def_property_readonly("obstacles", &obstaclesOf, "All obstacles, in ascending order of ids.");
    world.def_property_readonly("patches", &patchesOf, "All patches, in ascending order of ids.");
    world.def_property_readonly("items", &itemsOf, "All items, in ascending order of ids.");
    world.def_property_readonly("checkpoints", &checkpointsOf,
                                "All formation checkpoints, in ascending order of ids.");
    world.def_property_readonly(
        "areas", &areasOf,
        "All exits, sources and waiting areas, in ascending order of ids, with what they "
        "have seen.");
    world.def_property_readonly(
        "ring", [](const py::object& self) { return worldOf(self).ring(); },
        "True where the left and the right side of its box are joined.");
    world.def_property_readonly(
        "events", [](WorldHandle& self) { return listOf(self.get().events()); },
        "Events of the last step, in the order in which they happened.");
    world.def_property_readonly(
        "rejections", [](WorldHandle& self) { return rejectionsOf(self.get()); },
        "Commands that could not be applied in the last step, and why.");
    world.def_property_readonly(
        "contacts", [](WorldHandle& self) { return toPython(self.get().contacts()); },
        "Overlaps after the last step.");
    world.def_property_readonly(
        "stage_times", [](WorldHandle& self) { return stageTimesOf(self.get()); },
        "Wall time of each stage of the last step, and \"total\" [ms]. Not part of the state.");
    world.def_property_readonly(
        "last_command_step", [](WorldHandle& self) { return self.get().lastCommandStep(); },
        "Step of the last command that was applied; 0 for none.");
    world.def(
        "way_ahead", [](WorldHandle& self, const py::object& id) { return wayAhead(self.get(), id); },
        py::arg("character"),
        "The way of the character of an id to its place: corners round what stands still, both ends "
        "included, shape (n, 2)\n"
        "[m], a copy. Empty for the unmatched and where there is none. Fails with NotFoundError.");
    world.def_property_readonly(
        "standings", [](WorldHandle& self) { return toPython(self.get().standings()); },
        "Of each character its Standing: whether it stands in its place, and if not, what keeps it from "
        "there.");
    world.def(
        "forecast", &forecast, py::arg("group"), py::arg("order"),
        "What would come of an order that the group of that id were given now, and nothing else changed.\n"
        "Fails with NotFoundError.");
}

}  // namespace

void defineWorld(py::module_& module) {
    py::class_<WorldHandle> world(
        module, "World",
        "Deterministic simulation at a fixed time step.\n\n"
        "The same definition and commands give the same bits as every other program of this version,\n"
        "for any number of threads. A world belongs to one thread at a time.");
    world.def(py::init(&create), py::arg("definition"), py::arg("threads") = 1,
              "Makes a world.\n\n"
              "definition: a WorldDef, a Scenario, the path of a scenario file, or such a file's content as "
              "a dict.\n"
              "threads: 1 to 256; 0 for all cores. Results are the same.\n\n"
              "Fails with InvalidArgumentError, naming the faulty value, and as load_scenario() does.");
    world.def("submit", &WorldHandle::submit, py::arg("command"), py::kw_only(), py::arg("step") = py::none(),
              py::arg("client") = 0,
              "Queues a command: its body, as muster.ChangeGroup(1, count=50), for a step (without one for "
              "the next), "
              "or a Command with\n"
              "step, client and sequence of its own. Gives the Command. Fails with InvalidArgumentError "
              "where it is malformed or\n"
              "its step has passed; whether it can be applied is only known in its step: see `rejections`.");
    world.def("step", &WorldHandle::step, py::arg("count") = 1,
              "Advances by that many time steps, 0 or more. Other threads of Python run meanwhile. `events` "
              "and `rejections`\n"
              "are those of the last one.");
    world.def("__repr__", [](WorldHandle& self) {
        const World& w = self.get();
        return "<muster.World: " + std::to_string(w.characters().size()) + " characters in " +
               std::to_string(w.groupCount()) + " groups after " + std::to_string(w.stepCount()) + " steps>";
    });
    defineState(world);
    defineReadOuts(world);
}

}  // namespace muster::python
