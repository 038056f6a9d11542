#include "files/scenario/gestures_field.h"

#include <algorithm>

#include "muster/scenario.h"

namespace muster {

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

bool staysInside(std::string_view path) {
    constexpr std::string_view kSlashes = "/\\";
    if (!path.empty() && kSlashes.find(path.front()) != std::string_view::npos) return false;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find_first_of(kSlashes, begin), path.size());
        if (path.substr(begin, end - begin) == "..") return false;
        begin = end + 1;
    }
    return true;
}

Result<std::vector<Command>> loadScenarioGestures(const std::string& scenarioPath, const WorldDef& def) {
    if (def.gestures.empty()) return std::vector<Command>();
    const std::string where = scenarioPath + ": $.gestures";
    if (!staysInside(def.gestures)) {
        return invalidArgument(where + ": found " + describeJson(def.gestures) + ", expected " +
                               kInsideExpected);
    }
    auto commands = loadGestures(folderOf(scenarioPath) + def.gestures, def.parameters.stepTime);
    if (!commands.ok()) return commands.status().within(where);
    return commands;
}

}  // namespace muster
