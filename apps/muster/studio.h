// The studio: page and WebSocket on one port.
#pragma once

#include <string>

namespace muster {

/// Options of the studio.
struct StudioOptions {
    int port = 8080;  ///< Where the port is in use, the next free one is used.
    /// The first scenario to load: a name in the folder or a path; empty for the folder's default.
    std::string scenario;
    std::string scenarioFolder;           ///< Folder of the scenarios that the studio offers.
    std::string pageFolder;               ///< Folder of the built page.
    std::string engineFolder;             ///< Folder of the engine for browsers, where it is built.
    std::string takesFolder = "takes";    ///< Folder in which recordings are kept; it is created when needed.
    std::string placesFolder = "places";  ///< Folder in which places are kept, too.
    std::string site;                     ///< Address of a site, for links that need no studio; may be empty.
    int threads = 1;                      ///< Number of simulation threads; 0 uses all cores.
    bool lan = false;                     ///< Other machines of the network may connect, with a token.
    bool openBrowser = false;             ///< Opens the page in the desktop's browser.
    bool json = false;                    ///< Prints address and port as one JSON value.
};

/// Serves until interrupted. Returns the program's exit code; failures are printed on standard error.
int runStudio(const StudioOptions& options);

}  // namespace muster
