// Trajectories in JuPedSim's SQLite files.
#pragma once

#include <string>

#include "lab/measures/recording.h"

namespace muster {

/// True where a file begins as SQLite's files do.
bool isSqliteFile(const std::string& path);
/// Reads trajectories, frame rate and, where there is one, the ground; none where it changes. Fails with
/// ParseError, or with Unsupported where this build has no SQLite.
Result<Recording> readSqliteRecording(const std::string& path);

}  // namespace muster
