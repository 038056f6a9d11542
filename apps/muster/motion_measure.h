// Measures of motion over scenarios: slide of feet, speed of knees, depth below the floor.
#pragma once

#include <string>
#include <vector>

namespace muster {

/// muster motion --measure.
struct MeasureOptions {
    std::vector<std::string> scenarios;  ///< Files.
    std::int32_t count = 0;  ///< Characters of the first group instead of the scenario's; 0 for those.
    /// Simulated [s]; 0: until all have arrived and stand, at most a minute after the last touch.
    double seconds = 0.0;
    std::string clips;  ///< Folder of clips to play; empty for Muster's own.
    bool json = false;  ///< One JSON value, else a table.
};

/// Plays each scenario with the touches it carries and prints what its motion is like. Returns an exit code.
int measureMotion(const MeasureOptions& options);

}  // namespace muster
