// Places that directors keep: scenario files in one folder, and which scenario was shown last.
#pragma once

#include <string>
#include <string_view>

#include "muster/status.h"
#include "muster/world.h"

namespace muster {

/// Places as files NAME.json. All names are made here from titles.
class KeptPlaces {
public:
    /// The folder is made when something is put there.
    explicit KeptPlaces(std::string folder) : folder_(std::move(folder)) {}

    static constexpr const char* kPrefix = "places/";  ///< Before their names among scenarios.

    const std::string& folder() const { return folder_; }  ///< Where they lie.
    /// Writes a place and returns the path of its file. One of the same title is replaced. Fails with
    /// IoError.
    Result<std::string> put(const WorldDef& place) const;
    /// Remembers which scenario is shown, where places are kept here at all.
    void remember(const std::string& scenario) const;
    /// The scenario that was shown last; empty where that is not known.
    std::string last() const;

private:
    std::string pathOf(std::string_view stem) const;
    std::string folder_;
};

}  // namespace muster
