// The scenarios that the studio's picker offers.
#pragma once

#include <string>
#include <vector>

#include "muster/session.h"

namespace muster {

/// Scenario files of a folder, by file name without ".json"; those of folders in it as FOLDER/NAME.
class ScenarioFolder {
public:
    /// Looks through a folder and those in it, but for `gestures`, `schema` and hidden ones, no deeper. Files
    /// that cannot be read are reported on standard error and left out.
    static ScenarioFolder scan(const std::string& folder);

    /// Adds a file from anywhere and returns the name it got, or has already. Fails as loadScenario does.
    Result<std::string> add(const std::string& path);
    /// In the order of names, those of folders in it behind the others.
    const std::vector<ScenarioEntry>& entries() const { return entries_; }
    /// The one to begin with where none is asked for: "open", else the first; empty for none.
    std::string first() const;
    /// True where one bears that name.
    bool has(const std::string& name) const;
    /// Reads it anew. Fails with NotFound, or as loadScenario does.
    Result<WorldDef> load(const std::string& name) const;
    /// Reads the touches that it carries, for a world of that definition. Fails as load() and
    /// loadScenarioGestures do.
    Result<std::vector<Command>> gestures(const std::string& name, const WorldDef& def) const;
    /// Reads the clips that its characters move by: those of files that it names, else Muster's own. A name
    /// that is not in the folder is a take's: then the scenario is found by its title. Fails as clipsFor()
    /// does, or with NotFound where a take from elsewhere names files.
    Result<ClipLibrary> clips(const std::string& name, const WorldDef& def) const;

private:
    Status addAs(const std::string& name, const std::string& path);
    void addFolder(const std::string& folder, const std::string& prefix);
    const std::string* pathOf(const std::string& name) const;

    std::vector<ScenarioEntry> entries_;
    std::vector<std::string> paths_;  // Of the entries.
};

}  // namespace muster
