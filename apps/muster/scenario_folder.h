// The scenarios that the studio's picker offers.
#pragma once

#include <string>
#include <vector>

#include "muster/session/session.h"

namespace muster {

/// Scenario files of a folder, by file name without ".json".
class ScenarioFolder {
public:
    /// Looks through a folder; files that cannot be read are told on standard error and left out.
    static ScenarioFolder scan(const std::string& folder);

    /// Adds a file from anywhere and returns the name it got. Fails as loadScenario does.
    Result<std::string> add(const std::string& path);
    /// In the order of names.
    const std::vector<ScenarioEntry>& entries() const { return entries_; }
    /// The one to begin with where none is asked for: "open", else the first; empty for none.
    std::string first() const;
    /// True where one bears that name.
    bool has(const std::string& name) const;
    /// Reads it anew. Fails with NotFound, or as loadScenario does.
    Result<WorldDef> load(const std::string& name) const;

private:
    std::vector<ScenarioEntry> entries_;
    std::vector<std::string> paths_;  // Of the entries.
};

}  // namespace muster
