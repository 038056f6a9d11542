// Export of takes as USD text: animated bodies on their ground.
#pragma once

#include <memory>
#include <string>

#include "files/export/exporter.h"

namespace muster {

/// Writes one USDA file: for each character a SkelRoot with skeleton, animation and a skinned body, its shirt
/// in the colour of its group; ground, obstacles and patches as they are at the first frame; a camera that
/// sees all positions of the take. Z is up, one unit is one metre, and time code 0 is the first frame.
std::unique_ptr<Exporter> makeUsdExporter(const std::string& path);

}  // namespace muster
