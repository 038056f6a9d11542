// The scenarios that the studio offers.
#pragma once

#include <string>
#include <vector>

#include "muster/session.h"

namespace muster {

/// Scenario files of a folder by file name without ".json"; files in its subfolders are named FOLDER/NAME.
class ScenarioFolder {
public:
    /// Scans a folder and its direct subfolders, except `gestures`, `schema` and hidden ones. A file that
    /// cannot be read is reported on standard error and left out.
    static ScenarioFolder scan(const std::string& folder);

    /// Adds a file from any folder and returns its new or existing name. Fails like loadScenario.
    Result<std::string> add(const std::string& path);
    /// Adds all files of another folder, named PREFIX and the name of the file.
    void addFolder(const std::string& folder, const std::string& prefix);
    /// Adds a file of such a folder, and tells of it. Fails like loadScenario.
    Result<ScenarioEntry> addFile(const std::string& path, const std::string& prefix);
    /// Sorted by name; files in subfolders come last.
    const std::vector<ScenarioEntry>& entries() const { return entries_; }
    /// The default scenario: "open", otherwise the first; empty for none.
    std::string first() const;
    /// True where a scenario has that name.
    bool has(const std::string& name) const;
    /// Reads the scenario from its file. Fails with NotFound, or like loadScenario.
    Result<WorldDef> load(const std::string& name) const;
    /// Reads the touches that the scenario carries, for a world of that definition. Fails like load() and
    /// loadScenarioGestures.
    Result<std::vector<Command>> gestures(const std::string& name, const WorldDef& def) const;
    /// Reads the clips that its characters play: those of the files that it names, otherwise Muster's own. A
    /// name that is not in the folder belongs to a take; the scenario is then found by its title. Fails like
    /// clipsFor(), or with NotFound where a take from another machine names files.
    Result<ClipLibrary> clips(const std::string& name, const WorldDef& def) const;

private:
    Status addAs(const std::string& name, const std::string& path);
    const std::string* pathOf(const std::string& name) const;

    std::vector<ScenarioEntry> entries_;
    std::vector<std::string> paths_;  // Paths of the entries.
};

}  // namespace muster
