// The clips that a world plays.
#pragma once

#include <span>
#include <string>

#include "muster/clip.h"
#include "muster/patch.h"

namespace muster {

/// True where some clip moves by a file.
bool namesClipFiles(std::span<const ClipFacts> facts);

/// Muster's own clips, and in place of those of the same name the motions of the files that clip facts name
/// (BVH, relative to `folder`), brought onto Muster's skeleton. Fails as readBvh and retarget do, naming the
/// motion.
Result<ClipLibrary> clipsFor(std::span<const ClipFacts> facts, const std::string& folder);

}  // namespace muster
