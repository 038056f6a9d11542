// Takes as USD text: bodies in motion on their ground.
#pragma once

#include <memory>
#include <string>

#include "io/export/exporter.h"

namespace muster {

/// Writes one USDA file: for everyone a SkelRoot with skeleton, animation and a skinned body, its shirt in
/// the colour of its group; ground, obstacles and patches as they are at the first frame; a camera that sees
/// the whole way. Z is up, one unit is one metre; time code 0 is the first frame.
std::unique_ptr<Exporter> makeUsdExporter(const std::string& path);

}  // namespace muster
