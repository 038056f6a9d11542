// The studio: page and WebSocket on one port of the loopback interface.
#pragma once

#include <string>

namespace muster {

/// How the studio is started.
struct StudioOptions {
    std::string host = "127.0.0.1";  ///< Address to listen on; loopback only.
    int port = 8080;                 ///< The next free one is taken where it is in use.
    /// Loaded first; a name in the folder or a path; empty for the first one.
    std::string scenario;
    std::string scenarioFolder;         ///< Where the picker's scenarios lie.
    std::string pageFolder;             ///< The built page.
    std::string takesFolder = "takes";  ///< Where recordings are kept while they run; made when needed.
    int threads = 1;                    ///< Of the simulation; 0 takes what the machine has.
    bool openBrowser = false;           ///< Opens the page in the desktop's browser.
    bool json = false;                  ///< Tells address and port as one JSON value.
};

/// Serves until interrupted. Returns the program's exit code; failures are reported on standard error.
int runStudio(const StudioOptions& options);

}  // namespace muster
