// Export of takes as SQLite files of JuPedSim.
#pragma once

#include <memory>
#include <string>

#include "engine/ground/environment/environment.h"
#include "files/export/exporter.h"

namespace muster {

/// Writes JuPedSim's SQLite format, version 2: trajectories with directions, metadata, and the walkable area
/// as WKT. The area is written again whenever the static obstacles change; moving obstacles are left out.
/// begin() fails with Unsupported where this build has no SQLite.
std::unique_ptr<Exporter> makeJupedsimExporter(const std::string& path);

/// The ground outside all static obstacles as WKT: a POLYGON, or a MULTIPOLYGON where it is in several parts.
/// Discs have 32 corners. Empty where this build has no SQLite.
std::string walkableArea(const Environment& environment);

}  // namespace muster
