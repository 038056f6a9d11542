// Scenario and gesture files, parameters and maps.
#include <pybind11/stl.h>
#include "from_python.h"
#include "muster/parameter_table.h"

#include "muster/scenario.h"
#include "python_world.h"
#include "to_python.h"

namespace muster::python {
namespace {

py::object parameterList() {
    const py::object type = py::module_::import("muster.records").attr("Parameter");
    const Parameters defaults;
    py::list all;
    for (const ParameterInfo& info : parameterTable())
        all.append(type(std::string(info.name), std::string(info.unit), info.minimum, info.maximum,
                        info.get(defaults), info.whole(), std::string(info.description)));
    return all;
}

py::list commandList(Result<std::vector<Command>> commands) {
    return listOf(std::span<const Command>(take(std::move(commands))));
}

std::vector<Command> commandsFrom(const py::object& commands) {
    return fromPython<std::vector<Command>>(commands, "commands");
}

WorldDef definitionFrom(const py::object& definition) {
    return fromPython<WorldDef>(definition, "definition");
}

void defineFiles(py::module_& module) {
    module.def(
        "load_scenario", [](const py::object& path) { return toPython(take(loadScenario(pathFrom(path)))); },
        py::arg("path"));
    module.def(
        "parse_scenario",
        [](const std::string& text, const std::string& source, const py::object& folder) {
            return toPython(take(parseScenario(text, source, pathFrom(folder))));
        },
        py::arg("text"), py::arg("source_name"), py::arg("base_folder"));
    module.def(
        "write_scenario",
        [](const py::object& definition) { return writeScenario(definitionFrom(definition)); },
        py::arg("definition"),
        "The whole definition as the text of a scenario file, its map embedded. Reading it gives the same "
        "definition, bit\n"
        "for bit. Fails with InvalidArgumentError.");
    module.def(
        "scenario_warnings",
        [](const py::object& definition, std::size_t most) {
            return scenarioWarnings(definitionFrom(definition), most);
        },
        py::arg("definition"), py::arg("most") = 20,
        "Lists what is valid but likely a mistake, one sentence each: gaps narrower than a character, starts "
        "inside obstacles,\n"
        "groups that overlap. At most `most`.");
    module.def("scenario_schema", &scenarioSchema, "The JSON Schema of scenario files, as text.");
    module.def("gestures_schema", &gesturesSchema, "The JSON Schema of gesture files, as text.");
}

void defineGestures(py::module_& module) {
    module.def(
        "load_gestures",
        [](const py::object& path, const py::object& stepTime) {
            return commandList(loadGestures(pathFrom(path), stepTimeFrom(stepTime)));
        },
        py::arg("path"), py::arg("step_time"));
    module.def(
        "parse_gestures",
        [](const std::string& text, const std::string& source, const py::object& stepTime) {
            return commandList(parseGestures(text, source, stepTimeFrom(stepTime)));
        },
        py::arg("text"), py::arg("source_name"), py::arg("step_time"));
    module.def(
        "load_scenario_gestures",
        [](const py::object& path, const py::object& definition) {
            return commandList(loadScenarioGestures(pathFrom(path), definitionFrom(definition)));
        },
        py::arg("path"), py::arg("definition"));
    module.def(
        "write_gestures",
        [](const py::object& commands, const py::object& stepTime) {
            return writeGestures(commandsFrom(commands), stepTimeFrom(stepTime));
        },
        py::arg("commands"), py::arg("step_time") = 1.0 / 60.0,
        "Commands as the text of a gestures file for worlds of that step time [s]. Reading it gives the same "
        "commands,\n"
        "numbered again per client.");
}

void defineCommands(py::module_& module) {
    module.def(
        "encode_command",
        [](const py::object& command) {
            const std::vector<std::uint8_t> bytes = encodeCommand(fromPython<Command>(command, "command"));
            return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        },
        py::arg("command"), "A Command as bytes, for files and messages.");
    module.def(
        "decode_command",
        [](const py::object& bytes) { return toPython(take(decodeCommand(bytesFrom(bytes, "data")))); },
        py::arg("data"), "A Command from bytes. Fails with ParseError.");
    module.def(
        "validate_command",
        [](const py::object& command) { check(validateCommand(fromPython<Command>(command, "command"))); },
        py::arg("command"), "Checks what does not depend on a world. Fails with InvalidArgumentError.");
    module.def(
        "move_to_line",
        [](const py::object& left, const py::object& right) {
            return toPython(
                Order::moveToLine(fromPython<Vec2>(left, "left"), fromPython<Vec2>(right, "right")));
        },
        py::arg("left"), py::arg("right"));
}

void definePeople(py::module_& module) {
    module.def(
        "quantile",
        [](const py::object& distribution, double share) {
            if (!(share > 0.0 && share < 1.0))
                check(invalidArgument("share: found " + std::to_string(share) +
                                      ", expected a number in (0, 1)"));
            return fromPython<Distribution>(distribution, "distribution").quantile(share);
        },
        py::arg("distribution"), py::arg("share"));
    module.def(
        "adults", [] { return toPython(adults()); },
        "Adults as a PeopleDef: free speeds of mean 1.34 m/s and deviation 0.26 m/s, cut off at 0.5 and 2.2 "
        "m/s.");
    module.def("walking_speed_at_age", &walkingSpeedAtAge, py::arg("years"),
               "The mean free speed of persons by age [m/s], 5 to 90 years.");
}

void defineParameters(py::module_& module) {
    module.def("parameter_table", &parameterList,
               "All parameters: name, unit, range, default and description.");
    module.def(
        "parameter_preset", [](const std::string& name) { return toPython(take(parameterPreset(name))); },
        py::arg("name"),
        "The parameters of a preset, \"units\", \"people\" or \"paper\", as a dict of those that differ from "
        "the "
        "defaults.\n"
        "Fails with NotFoundError.");
    module.def(
        "parse_map", [](const std::string& text) { return toPython(take(parseMap(text))); }, py::arg("text"),
        "The MapGrid of the text of a MovingAI .map file. Fails with ParseError, naming the line.");
    module.def(
        "default_clip_facts", [] { return toPython(defaultClipFacts()); },
        "Facts of the clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this "
        "order.");
}

}  // namespace

void defineScenarios(py::module_& module) {
    defineFiles(module);
    defineGestures(module);
    defineCommands(module);
    definePeople(module);
    defineParameters(module);
}

}  // namespace muster::python
