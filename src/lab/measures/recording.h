// Trajectories from files: those of `muster play` and `muster export`, of PedPy and of JuPedSim.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lab/measures/region.h"
#include "lab/measures/trajectories.h"

namespace muster {

/// The content of a file of trajectories.
struct Recording {
    Trajectories trajectories;
    std::optional<Region> walkable;  ///< The ground, where the file has it (JuPedSim's SQLite).
};

/// Reads `path`. By its content it is one of
///   SQLite of JuPedSim, version 1 or 2;
///   CSV with a header that names at least t, id, x and y, as `muster play --trajectory` writes;
///   text of lines `id frame x y ...` with comments from #, of which one names the frame rate ("framerate:
///   16") and one may name centimetres ("x/cm", "in cm"), as PedPy, JuPedSim and `muster export` write.
/// `frameRate` stands for that of a text without one; 0 for none. Fails with IoError, ParseError naming the
/// line, or Unsupported where this build has no SQLite.
Result<Recording> readRecording(const std::string& path, double frameRate = 0.0);
/// Reads the content of a text file, as readRecording() does.
Result<Recording> parseRecording(std::string_view text, double frameRate = 0.0);

}  // namespace muster
