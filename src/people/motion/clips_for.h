// The clips that a world plays.
#pragma once

#include <span>
#include <string>

#include "muster/clip.h"
#include "muster/ground.h"

namespace muster {

/// True if any clip has a motion file.
bool namesClipFiles(std::span<const ClipFacts> facts);

/// Muster's own clips. Motion files named by clip facts (BVH, relative to `folder`) are retargeted and
/// replace the clips of the same name. Fails like readBvh and retarget; the message names the motion.
Result<ClipLibrary> clipsFor(std::span<const ClipFacts> facts, const std::string& folder);

}  // namespace muster
