// Retargets motions of other skeletons to Muster's skeleton.
#pragma once

#include <optional>
#include <string>

#include "muster/clip.h"
#include "people/clips/joint_roles.h"

namespace muster {

/// Options of retargeting.
struct RetargetOptions {
    std::string name;            ///< Name of the clip.
    std::string motion = "run";  ///< Name of the clip's motion.
    std::optional<bool> cyclic;  ///< Whether it repeats; if not set, isCyclic() decides.
};

/// Retargets a motion to Muster's skeleton. Bones get the directions of the file's bones, hips and travel are
/// scaled by the length of the legs, and contacts are found by height and speed. A cyclic clip travels
/// straight, or along an arc if it turns, and the difference of its ends is distributed over it. Other clips
/// follow the smoothed path of the hips. Files of Muster's own skeleton are read unchanged. Fails with
/// Unsupported if the skeleton lacks hips or legs (the message names the missing joints), and with
/// InvalidArgument below three frames.
Result<Clip> retarget(const BvhMotion& motion, const RetargetOptions& options = {});

/// True for files of Muster's own skeleton, as bvhText writes it.
bool isOwnSkeleton(const BvhMotion& motion);

/// True if the last frame repeats the first after one travel and the limbs still move at both ends.
bool isCyclic(const BvhMotion& motion);

/// Replaces the contacts of a clip by those found from heights and speeds of its limbs (a foot within 5 cm of
/// the ground and slower than 0.5 m/s, or 1 m/s in a fast clip).
void findContacts(Clip& clip);

}  // namespace muster
