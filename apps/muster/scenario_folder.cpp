#include "scenario_folder.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "muster/scenario/scenario.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

ScenarioEntry describe(const std::string& name, const WorldDef& def) {
    ScenarioEntry entry{name, def.name, def.description, 0};
    for (const GroupDef& group : def.groups) entry.characters += static_cast<std::uint32_t>(std::max(0, group.count));
    return entry;
}

}  // namespace

ScenarioFolder ScenarioFolder::scan(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folder, error)) {
        if (file.path().extension() == ".json" && file.is_regular_file(error)) found.push_back(file.path().string());
    }
    std::sort(found.begin(), found.end());
    ScenarioFolder scenarios;
    for (const std::string& path : found) {
        const auto added = scenarios.add(path);
        if (!added.ok()) std::fprintf(stderr, "muster studio: %s\n", added.status().message().c_str());
    }
    return scenarios;
}

Result<std::string> ScenarioFolder::add(const std::string& path) {
    const auto def = loadScenario(path);
    if (!def.ok()) return def.status();
    const std::string name = fs::path(path).stem().string();
    const ScenarioEntry entry = describe(name, def.value());
    const auto same = std::find_if(entries_.begin(), entries_.end(),
                                   [&](const ScenarioEntry& other) { return other.name == name; });
    if (same != entries_.end()) {
        paths_[static_cast<std::size_t>(same - entries_.begin())] = path;
        *same = entry;
    } else {
        entries_.push_back(entry);
        paths_.push_back(path);
    }
    return name;
}

std::string ScenarioFolder::first() const {
    if (has("open")) return "open";
    return entries_.empty() ? std::string() : entries_.front().name;
}

bool ScenarioFolder::has(const std::string& name) const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const ScenarioEntry& entry) { return entry.name == name; });
}

Result<WorldDef> ScenarioFolder::load(const std::string& name) const {
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].name == name) return loadScenario(paths_[i]);
    return Status(StatusCode::NotFound, "no scenario is called '" + name + "'");
}

}  // namespace muster
