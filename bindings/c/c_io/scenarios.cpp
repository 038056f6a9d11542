// Scenarios and gestures.
#include "bindings/c/c_world/command_list.h"
#include "bindings/c/c_world/world_handle.h"
#include "muster/muster.h"
#include "muster/scenario.h"

namespace muster::c_api {
namespace {

/// A scenario, its C struct, and the memory of its warnings.
struct ScenarioThing {
    explicit ScenarioThing(WorldDef made) : def(std::move(made)) {
        written = writeC<MusterWorldDef>(def, arena);
    }

    WorldDef def;
    Arena arena;
    MusterWorldDef written;
    Arena warnings;
};

using Scenarios = HandleTable<MusterScenarioId, ScenarioThing>;

Scenarios& scenarios() {
    static Scenarios& table = *new Scenarios("scenario");
    return table;
}

/// Takes what `read` gives and gives its handle; none where it fails.
template <class Read>
MusterStatus addScenario(MusterScenarioId* outScenario, Read&& read) noexcept {
    return call([&]() -> Status {
        if (outScenario == nullptr) return nullArgument("outScenario");
        *outScenario = {0, 0};
        Result<WorldDef> def = read();
        if (!def.ok()) return def.status();
        *outScenario = scenarios().add(std::make_unique<ScenarioThing>(*std::move(def)));
        return {};
    });
}
/// Calls `work` with a scenario.
template <class Work>
MusterStatus withScenario(MusterScenarioId id, Work&& work) noexcept {
    return call([&]() -> Status {
        const Result<ScenarioThing*> found = scenarios().find(id);
        return found.ok() ? work(**found) : found.status();
    });
}
/// Takes the commands that `read` gives and gives the handle of their list.
template <class Read>
MusterStatus addGestures(MusterCommandListId* outList, Read&& read) noexcept {
    return call([&]() -> Status {
        if (outList == nullptr) return nullArgument("outList");
        *outList = {0, 0};
        Result<std::vector<Command>> commands = read();
        if (!commands.ok()) return commands.status();
        *outList = addCommandList(*std::move(commands));
        return {};
    });
}

Status giveText(const std::string& text, MusterBuffer* out) {
    if (out == nullptr) return nullArgument("outText");
    *out = makeBuffer(text.data(), text.size());
    return {};
}

Status checkStepTime(double stepTime) {
    if (stepTime >= 1.0 / 240.0 && stepTime <= 0.1) return {};
    return invalidArgument("stepTime: found no number from 1/240 to 1/10");
}

Result<std::vector<Command>> readCommands(const MusterCommand* commands, std::int32_t count,
                                          double stepTime) {
    if (const Status valid = checkStepTime(stepTime); !valid.ok()) return valid;
    std::vector<Command> read;
    FromC reader;
    reader.items(commands, count, read, "commands");
    if (!reader.status().ok()) return reader.status();
    for (std::size_t i = 0; i < read.size(); ++i)
        if (const Status valid = validateCommand(read[i]); !valid.ok())
            return valid.within("commands[" + std::to_string(i) + "]");
    return read;
}

}  // namespace
}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterStatus muster_scenario_load(const char* path, MusterScenarioId* outScenario) {
    return addScenario(outScenario, [&]() -> Result<WorldDef> {
        return path == nullptr ? nullArgument("path") : loadScenario(path);
    });
}

MusterStatus muster_scenario_parse(const char* text, size_t size, const char* sourceName,
                                   const char* baseFolder, MusterScenarioId* outScenario) {
    return addScenario(outScenario, [&]() -> Result<WorldDef> {
        if (const Status given = needPointers({"text", "sourceName"}, text, sourceName); !given.ok())
            return given;
        return parseScenario({text, size}, sourceName, baseFolder == nullptr ? "" : baseFolder);
    });
}

MusterStatus muster_scenario_from_def(const MusterWorldDef* def, MusterScenarioId* outScenario) {
    return addScenario(outScenario, [&]() -> Result<WorldDef> {
        WorldDef read;
        if (const Status fits = readC(def, read, "def"); !fits.ok()) return fits;
        return read;
    });
}

MusterStatus muster_scenario_destroy(MusterScenarioId scenario) {
    return call([&] { return scenarios().destroy(scenario); });
}

MusterStatus muster_scenario_def(MusterScenarioId scenario, MusterWorldDef* outDef) {
    return withScenario(scenario, [&](ScenarioThing& thing) -> Status {
        if (const Status fits = needStruct(outDef, "outDef"); !fits.ok()) return fits;
        *outDef = thing.written;
        return {};
    });
}

MusterStatus muster_scenario_create_world(MusterScenarioId scenario, int32_t threads,
                                          MusterWorldId* outWorld) {
    return withScenario(scenario, [&](ScenarioThing& thing) -> Status {
        if (outWorld == nullptr) return nullArgument("outWorld");
        *outWorld = {0, 0};
        if (threads < 0 || threads > 256)
            return invalidArgument("threads: found " + std::to_string(threads) + ", expected 0 to 256");
        Result<World> world = World::create(thing.def, threads);
        if (!world.ok()) return world.status();
        *outWorld = addWorld(std::make_unique<WorldHandle>(*std::move(world)));
        return {};
    });
}

MusterStatus muster_scenario_text(MusterScenarioId scenario, MusterBuffer* outText) {
    return withScenario(scenario,
                        [&](ScenarioThing& thing) { return giveText(writeScenario(thing.def), outText); });
}

MusterStatus muster_scenario_save(MusterScenarioId scenario, const char* path) {
    return withScenario(scenario, [&](ScenarioThing& thing) {
        return path == nullptr ? nullArgument("path") : saveScenario(thing.def, path);
    });
}

MusterStatus muster_scenario_warnings(MusterScenarioId scenario, int32_t most,
                                      const char* const** outSentences, int32_t* outCount) {
    return withScenario(scenario, [&](ScenarioThing& thing) -> Status {
        if (const Status given = needPointers({"outSentences", "outCount"}, outSentences, outCount);
            !given.ok())
            return given;
        if (most < 0) return invalidArgument("most: found " + std::to_string(most) + ", expected 0 or more");
        const auto warnings = scenarioWarnings(thing.def, static_cast<std::size_t>(most));
        thing.warnings.reset();
        auto* const sentences = thing.warnings.make<const char*>(warnings.size());
        for (std::size_t i = 0; i < warnings.size(); ++i) sentences[i] = thing.warnings.text(warnings[i]);
        *outSentences = sentences;
        *outCount = static_cast<std::int32_t>(warnings.size());
        return {};
    });
}

MusterStatus muster_scenario_schema(MusterBuffer* outText) {
    return call([&] { return giveText(scenarioSchema(), outText); });
}

MusterStatus muster_gestures_load(const char* path, double stepTime, MusterCommandListId* outList) {
    return addGestures(outList, [&]() -> Result<std::vector<Command>> {
        if (path == nullptr) return nullArgument("path");
        const Status valid = checkStepTime(stepTime);
        return valid.ok() ? loadGestures(path, stepTime) : valid;
    });
}

MusterStatus muster_gestures_parse(const char* text, size_t size, const char* sourceName, double stepTime,
                                   MusterCommandListId* outList) {
    return addGestures(outList, [&]() -> Result<std::vector<Command>> {
        if (const Status given = needPointers({"text", "sourceName"}, text, sourceName); !given.ok())
            return given;
        const Status valid = checkStepTime(stepTime);
        return valid.ok() ? parseGestures({text, size}, sourceName, stepTime) : valid;
    });
}

MusterStatus muster_gestures_parse_commands(const char* text, size_t size, const char* sourceName,
                                            double stepTime, MusterCommandListId* outList) {
    return addGestures(outList, [&]() -> Result<std::vector<Command>> {
        if (const Status given = needPointers({"text", "sourceName"}, text, sourceName); !given.ok())
            return given;
        const Status valid = checkStepTime(stepTime);
        return valid.ok() ? parseCommands({text, size}, sourceName, stepTime) : valid;
    });
}

MusterStatus muster_gestures_of_scenario(const char* scenarioPath, MusterScenarioId scenario,
                                         MusterCommandListId* outList) {
    return withScenario(scenario, [&](ScenarioThing& thing) -> Status {
        if (const Status given = needPointers({"scenarioPath", "outList"}, scenarioPath, outList);
            !given.ok())
            return given;
        *outList = {0, 0};
        Result<std::vector<Command>> commands = loadScenarioGestures(scenarioPath, thing.def);
        if (!commands.ok()) return commands.status();
        *outList = addCommandList(*std::move(commands));
        return {};
    });
}

MusterStatus muster_gestures_schema(MusterBuffer* outText) {
    return call([&] { return giveText(gesturesSchema(), outText); });
}

MusterStatus muster_gestures_text(const MusterCommand* commands, int32_t commandCount, double stepTime,
                                  MusterBuffer* outText) {
    return call([&]() -> Status {
        const Result<std::vector<Command>> read = readCommands(commands, commandCount, stepTime);
        return read.ok() ? giveText(writeGestures(*read, stepTime), outText) : read.status();
    });
}

MusterStatus muster_gestures_save(const MusterCommand* commands, int32_t commandCount, double stepTime,
                                  const char* path) {
    return call([&]() -> Status {
        if (path == nullptr) return nullArgument("path");
        const Result<std::vector<Command>> read = readCommands(commands, commandCount, stepTime);
        return read.ok() ? saveGestures(*read, stepTime, path) : read.status();
    });
}
