// Export of takes as text for PedPy.
#pragma once

#include <memory>
#include <string>

#include "files/export/exporter.h"

namespace muster {

/// Writes the text that PedPy reads: `# framerate: N`, then one line `id frame x y z` per character and
/// frame, in metres. z is 0, the ground. Frames are numbered from 0.
std::unique_ptr<Exporter> makePedpyExporter(const std::string& path);

}  // namespace muster
