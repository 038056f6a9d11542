// Export of all joint positions as JSON, for comparison with other files.
#pragma once

#include <memory>
#include <string>

#include "files/export/exporter.h"

namespace muster {

/// Writes one JSON object: `joints`, their names; `fps`; and `frames`, each with its `time` from the first
/// frame [s] and `characters`, each with `id` and `positions`: x, y, z of every joint in the world [m],
/// rounded to a micrometre.
std::unique_ptr<Exporter> makeJointListExporter(const std::string& path);

}  // namespace muster
