// Export of takes as glTF: animated bodies on their ground.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "files/export/exporter.h"

namespace muster {

/// Writes one binary glTF 2.0 file (GLB): a skinned body with skeleton for each character, its shirt in the
/// colour of its group; ground, obstacles and patches as they are at the first frame; a camera that sees all
/// positions of the take. One animation moves everything; it begins at 0 s, at any time of the take. Y is up,
/// bodies face +Z in the rest pose, and one unit is one metre. During the export a second file,
/// PATH.data.part, lies in the same folder. Fails with LimitExceeded where characters and frames exceed the 4
/// GiB of such files.
std::unique_ptr<Exporter> makeGltfExporter(const std::string& path);

}  // namespace muster
