// Takes as a folder of BVH files, one per character.
#pragma once

#include <memory>
#include <string>

#include "io/export/exporter.h"

namespace muster {

/// Writes `folder`/character-ID.bvh for everyone: Muster's skeleton at the character's size, its root in the
/// world, in centimetres (see bvhText). All files have the same frames: who comes later waits where it
/// begins, who goes stays.
std::unique_ptr<Exporter> makeBvhExporter(const std::string& folder);

}  // namespace muster
