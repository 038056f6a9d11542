// Export of takes as a folder of BVH files, one per character.
#pragma once

#include <memory>
#include <string>

#include "files/export/exporter.h"

namespace muster {

/// Writes `folder`/character-ID.bvh for each character: Muster's skeleton at the character's size, with its
/// root in world coordinates, in centimetres (see bvhText). All files have the same frames: a character waits
/// at its first position until it appears, and stays at its last position after it leaves.
std::unique_ptr<Exporter> makeBvhExporter(const std::string& folder);

}  // namespace muster
