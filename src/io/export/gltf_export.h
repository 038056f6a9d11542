// Takes as glTF: bodies in motion on their ground.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "io/export/exporter.h"

namespace muster {

/// Writes one binary glTF 2.0 file (GLB): a skinned body with skeleton for everyone, its shirt in the colour
/// of its group; ground, obstacles and patches as they are at the first frame; a camera that sees the whole
/// way. One animation moves all; it begins at 0 s, whatever the take's time. Y is up, bodies face +Z in the
/// rest pose, one unit is one metre. While it is written a second file, PATH.data.part, lies beside it.
/// Fails with LimitExceeded where characters and frames are more than the 4 GiB of such files can hold.
std::unique_ptr<Exporter> makeGltfExporter(const std::string& path);

}  // namespace muster
