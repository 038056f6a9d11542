// A static folder with the studio, which any web host serves: the page with its engine beside it.
#pragma once

#include <cstddef>
#include <string>

#include "muster/status.h"

namespace muster {

/// What a site is made from.
struct SiteDef {
    std::string pageFolder;      ///< Of the built page.
    std::string engineFolder;    ///< Of the WebAssembly modules.
    std::string scenarioFolder;  ///< Of the scenarios that it offers.
    std::string scenario;        ///< Shown first; empty for the folder's default.
    std::string output;          ///< Made where it is not there; one that holds something else is refused.
};

/// What was written.
struct SiteReport {
    std::size_t files = 0;      ///< Number of files.
    std::size_t bytes = 0;      ///< Of all files.
    std::size_t scenarios = 0;  ///< Number of scenarios, without their gestures.
};

/// Writes the site, with relative addresses only, a manifest, and a service worker that keeps its files.
/// Files of an older site in the folder are removed. Fails with NotFound where something of it is not built,
/// with InvalidArgument where the folder holds something else, and with IoError.
Result<SiteReport> writeSite(const SiteDef& def);

}  // namespace muster
