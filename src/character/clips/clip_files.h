// A folder of clips: one BVH file each, and clips.json with what BVH cannot say.
#pragma once

#include <string>

#include "muster/clip.h"

namespace muster {

inline constexpr const char* kClipList = "clips.json";  ///< The list in a folder of clips.

/// Writes NAME.bvh for every clip and the list into `folder`, making it. Ratios are to the clip "run";
/// without one, to 2.6 m/s. Fails with IoError, or InvalidArgument where a name is no file name.
Status writeClips(const ClipLibrary& library, const std::string& folder);

/// Reads what writeClips wrote, or what others made like it; see docs/method/motion-clips.md. Fails, naming
/// file and culprit, where anything is missing or does not fit.
Result<ClipLibrary> loadClips(const std::string& folder);

}  // namespace muster
