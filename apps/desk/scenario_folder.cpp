#include "scenario_folder.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "muster/scenario.h"
#include "people/motion/clips_for.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

ScenarioEntry describe(const std::string& name, const WorldDef& def) {
    ScenarioEntry entry{name, def.name, def.description, 0};
    for (const GroupDef& group : def.groups)
        entry.characters += static_cast<std::uint32_t>(std::max(0, group.count));
    return entry;
}

/// False for hidden folders and for the folders of gestures and schemas.
bool holdsScenarios(const std::string& name) {
    return name != "gestures" && name != "schema" && name.front() != '.';
}

Status notFound(const std::string& name) {
    return {StatusCode::NotFound, "no scenario is called '" + name + "'"};
}

}  // namespace

ScenarioFolder ScenarioFolder::scan(const std::string& folder) {
    std::vector<std::string> inner;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (entry->is_directory(ignored) && holdsScenarios(name)) inner.push_back(name);
    }
    std::sort(inner.begin(), inner.end());
    ScenarioFolder scenarios;
    scenarios.addFolder(folder, "");
    for (const std::string& name : inner) scenarios.addFolder((fs::path(folder) / name).string(), name + "/");
    return scenarios;
}

void ScenarioFolder::addFolder(const std::string& folder, const std::string& prefix) {
    std::vector<std::string> found;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() == ".json" && entry->is_regular_file(ignored))
            found.push_back(entry->path().string());
    }
    std::sort(found.begin(), found.end());
    for (const std::string& path : found) {
        const Status added = addAs(prefix + fs::path(path).stem().string(), path);
        if (!added.ok()) std::fprintf(stderr, "muster studio: %s\n", added.message().c_str());
    }
}

Result<std::string> ScenarioFolder::add(const std::string& path) {
    std::error_code error;
    for (std::size_t i = 0; i < paths_.size(); ++i)
        if (fs::equivalent(paths_[i], path, error)) return entries_[i].name;
    const std::string name = fs::path(path).stem().string();
    if (Status s = addAs(name, path); !s.ok()) return s;
    return name;
}

Result<ScenarioEntry> ScenarioFolder::addFile(const std::string& path, const std::string& prefix) {
    const std::string name = prefix + fs::path(path).stem().string();
    if (Status s = addAs(name, path); !s.ok()) return s;
    return *std::find_if(entries_.begin(), entries_.end(),
                         [&](const ScenarioEntry& entry) { return entry.name == name; });
}

Status ScenarioFolder::addAs(const std::string& name, const std::string& path) {
    const auto def = loadScenario(path);
    if (!def.ok()) return def.status();
    const ScenarioEntry entry = describe(name, def.value());
    const auto same = std::find_if(entries_.begin(), entries_.end(),
                                   [&](const ScenarioEntry& other) { return other.name == name; });
    if (same != entries_.end()) {
        paths_[same - entries_.begin()] = path;
        *same = entry;
    } else {
        entries_.push_back(entry);
        paths_.push_back(path);
    }
    return {};
}

std::string ScenarioFolder::first() const {
    for (const char* name : {"fountain", "open"})
        if (has(name)) return name;
    return entries_.empty() ? std::string() : entries_.front().name;
}

bool ScenarioFolder::has(const std::string& name) const {
    return pathOf(name) != nullptr;
}

const std::string* ScenarioFolder::pathOf(const std::string& name) const {
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].name == name) return &paths_[i];
    return nullptr;
}

Result<WorldDef> ScenarioFolder::load(const std::string& name) const {
    const std::string* path = pathOf(name);
    return path != nullptr ? loadScenario(*path) : notFound(name);
}

Result<std::vector<Command>> ScenarioFolder::gestures(const std::string& name, const WorldDef& def) const {
    const std::string* path = pathOf(name);
    return path != nullptr ? loadScenarioGestures(*path, def) : notFound(name);
}

Result<ClipLibrary> ScenarioFolder::clips(const std::string& name, const WorldDef& def) const {
    const std::string* path = pathOf(name);
    if (path != nullptr) return clipsFor(def.clips, fs::path(*path).parent_path().string());
    // A take gives only the title of its scenario.
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].title == def.name)
            return clipsFor(def.clips, fs::path(paths_[i]).parent_path().string());
    // The folder of the clip files is unknown for a take from another machine.
    return namesClipFiles(def.clips) ? notFound(name).within("clip files") : clipsFor({}, {});
}

}  // namespace muster
