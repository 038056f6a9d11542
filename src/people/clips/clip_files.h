// A folder of clips: one BVH file per clip, and clips.json with the facts that BVH cannot express.
#pragma once

#include <string>

#include "muster/clip.h"

namespace muster {

inline constexpr const char* kClipList = "clips.json";  ///< File name of the list of clips.

/// Writes NAME.bvh for every clip and the list into `folder`, which is created. Speed ratios are relative to
/// the clip "run", or to 2.6 m/s without one. Fails with IoError, or with InvalidArgument if a name is not a
/// file name.
Status writeClips(const ClipLibrary& library, const std::string& folder);

/// Reads a folder in the format of writeClips (docs/method/motion-clips.md). Fails if anything is missing or
/// invalid; the message names the file and the field.
Result<ClipLibrary> loadClips(const std::string& folder);

}  // namespace muster
