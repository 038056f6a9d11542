// Bodies and clips as streams of numbers.
#pragma once

#include <span>
#include <string>

#include "files/export/player/crowd_track.h"
#include "people/bodies/body.h"

namespace muster {

/// The skeleton, then for each kind of body that `track` has seen its fine and its coarse mesh.
std::string playerBodies(const CrowdTrack& track);
/// The poses of clips, in their order.
std::string playerClips(const ClipLibrary& library, std::span<const PlayedClip> clips);

}  // namespace muster
