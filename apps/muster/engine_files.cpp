#include "engine_files.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "base/hash.h"
#include "base/text_file.h"
#include "json/json.h"
#include "muster/scenario.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostModuleBytes = std::size_t{64} << 20;
constexpr const char* kModules[] = {"muster-engine.js", "muster-engine.wasm.xz", "muster-engine-rest.wasm"};
/// For isolated pages, where they are built.
constexpr const char* kThreadModules[] = {"muster-engine-threads.js", "muster-engine-threads.worker.js",
                                          "muster-engine-threads.wasm"};
constexpr std::string_view kJsonEnds = ".json";

bool allThere(const std::string& folder, std::span<const char* const> names) {
    return std::all_of(names.begin(), names.end(), [&](const char* name) {
        std::error_code ignored;
        return fs::is_regular_file(fs::path(folder) / name, ignored);
    });
}

Result<FileTexts> readModules(const std::string& folder, std::span<const char* const> names) {
    FileTexts files;
    for (const char* name : names) {
        const fs::path path = fs::path(folder) / name;
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored))
            return Status(StatusCode::NotFound,
                          path.string() + ": the engine for browsers is not built; ./run -- site builds it");
        auto bytes = readTextFile(path.string(), kMostModuleBytes);
        if (!bytes.ok()) return bytes.status();
        files[name] = std::move(bytes).value();
    }
    return files;
}

bool isGestures(const std::string& path) {
    return path.find("gestures/") != std::string::npos;
}

}  // namespace

std::vector<std::string> filesBelow(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored))
            found.push_back(entry->path().lexically_relative(folder).generic_string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string versionOf(const FileTexts& files) {
    Hash hash;
    for (const auto& [path, bytes] : files) {
        hash.add(path);
        hash.add(bytes);
    }
    return toHex(hash.value());
}

bool engineBuilt(const std::string& folder) {
    return allThere(folder, kModules);
}

Result<FileTexts> engineModules(const std::string& folder) {
    return readModules(folder, kModules);
}

Result<FileTexts> threadModules(const std::string& folder) {
    return allThere(folder, kThreadModules) ? readModules(folder, kThreadModules) : FileTexts();
}

Result<ScenarioTexts> scenarioTexts(const std::string& folder, bool check) {
    ScenarioTexts texts;
    Json scenarios = Json::object(), gestures = Json::object();
    for (const std::string& path : filesBelow(folder)) {
        if (!path.ends_with(kJsonEnds) || path.starts_with("schema/") || path.find("/.") != std::string::npos)
            continue;
        const std::string full = (fs::path(folder) / path).string();
        auto text = readTextFile(full);
        if (!text.ok()) return text.status();
        if (isGestures(path)) {
            gestures[path] = std::move(text).value();
            continue;
        }
        if (const auto read = check ? loadScenario(full) : Result<WorldDef>(WorldDef()); !read.ok())
            return read.status();
        texts.names.push_back(path.substr(0, path.size() - kJsonEnds.size()));
        scenarios[path] = std::move(text).value();
    }
    if (texts.names.empty()) return Status(StatusCode::NotFound, folder + ": found no scenario");
    texts.scenarios = compactJson(scenarios);
    texts.gestures = compactJson(gestures);
    return texts;
}

}  // namespace muster
