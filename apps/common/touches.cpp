#include "touches.h"

#include <filesystem>

#include "muster/scenario.h"

namespace muster {

void Touches::addTo(Subcommand& command) {
    const Option file = command.option(
        "--gestures", gestures, "Touches to give to the scenario, as JSON; without it nobody touches.");
    command.flag("--demo", demo, "Gives the touches that the scenario carries.").excludes(file);
}

Result<std::string> Touches::file(const std::string& scenarioPath, const WorldDef& def) const {
    if (!demo) return gestures;
    if (def.gestures.empty())
        return invalidArgument("--demo: " + scenarioPath +
                               " carries no gestures, expected it to name some under \"gestures\"");
    return (std::filesystem::path(scenarioPath).parent_path() / def.gestures).string();
}

Result<std::vector<Command>> Touches::load(const std::string& scenarioPath, const WorldDef& def) const {
    if (const auto found = file(scenarioPath, def); !found.ok()) return found.status();
    if (demo) return loadScenarioGestures(scenarioPath, def);
    if (gestures.empty()) return std::vector<Command>();
    return loadGestures(gestures, def.parameters.stepTime);
}

}  // namespace muster
