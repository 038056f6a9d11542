// Parts of the command motion: measures over scenarios (foot slide, knee speed, depth below the floor), and
// pictures of clips.
#pragma once

#include <string>
#include <vector>

#include "muster/clip.h"
#include "muster/status.h"

namespace muster {

/// Options of `muster motion --measure`.
struct MeasureOptions {
    std::vector<std::string> scenarios;  ///< Paths of scenario files.
    std::int32_t count = 0;  ///< Characters of the first group instead of the scenario's; 0 for those.
    /// Simulated time [s]; 0 ends when all characters have arrived and stand, at most a minute after the last
    /// touch.
    double seconds = 0.0;
    std::string clips;  ///< Folder of clips to play; empty for Muster's own clips.
    bool json = false;  ///< Prints JSON instead of a table.
};

/// Simulates each scenario with the touches it carries and prints the measures of its motion. Returns an exit
/// code.
int measureMotion(const MeasureOptions& options);

/// Draws each clip as a strip of poses into `folder`/NAME.svg. The folder is created where it does not exist.
/// Fails with IoError.
Status writeStrips(const std::vector<Clip>& clips, const std::string& folder);

}  // namespace muster
