// Bodies and clips as streams of numbers.
#pragma once

#include <span>
#include <string>

#include "character/bodies/body.h"
#include "io/export/player/crowd_track.h"

namespace muster {

/// The skeleton, then for each kind of body that `track` has seen its fine and its coarse mesh.
std::string playerBodies(const CrowdTrack& track);
/// The poses of clips, in their order.
std::string playerClips(const ClipLibrary& library, std::span<const PlayedClip> clips);

}  // namespace muster
