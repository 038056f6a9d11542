// The files of the engine for browsers: the WebAssembly modules, and the scenarios that they offer.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster {

/// Files by their paths.
using FileTexts = std::map<std::string, std::string>;

/// A number that follows from paths and contents.
std::string versionOf(const FileTexts& files);

/// True where that folder holds all modules that are needed.
bool engineBuilt(const std::string& folder);
/// The modules that are needed. Fails with NotFound, naming the file, where one is not built.
Result<FileTexts> engineModules(const std::string& folder);
/// Those for isolated pages; none where they are not all built.
Result<FileTexts> threadModules(const std::string& folder);

/// The scenarios of a folder, as the engine gets them.
struct ScenarioTexts {
    std::string scenarios;           ///< JSON: an object from paths ("market.json") to texts.
    std::string gestures;            ///< The same of gestures, which are needed later.
    std::vector<std::string> names;  ///< Of the scenarios ("paper/x06-course"), in their order.
};
/// Reads them. Fails with NotFound where there are none, and with `check` where one cannot be loaded.
Result<ScenarioTexts> scenarioTexts(const std::string& folder, bool check);

/// The regular files below a folder, as paths relative to it, in their order.
std::vector<std::string> filesBelow(const std::string& folder);

}  // namespace muster
