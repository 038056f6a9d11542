// Motion of other skeletons on Muster's own.
#pragma once

#include <optional>
#include <string>

#include "character/clips/joint_roles.h"
#include "muster/clip.h"

namespace muster {

/// How to bring a motion onto the skeleton.
struct RetargetOptions {
    std::string name;            ///< Of the clip.
    std::string motion = "run";  ///< Of the clip.
    std::optional<bool> cyclic;  ///< Whether it repeats; nothing: judged by the motion, see isCyclic().
};

/// Brings a motion onto Muster's skeleton by the parts joints play: bones point where the file's point, hips
/// and travel are scaled by the length of the legs, contacts are found by height and speed. A cyclic clip
/// travels straight, or along an arc where it turns, and what its ends differ is spread over it; else it
/// travels as the hips do, smoothed. Files of Muster's own skeleton come back as they were written. Fails
/// with Unsupported, naming what is missing, where the skeleton has no hips or no legs, with InvalidArgument
/// below three frames.
Result<Clip> retarget(const BvhMotion& motion, const RetargetOptions& options = {});

/// True for files of Muster's own skeleton, as bvhText writes it.
bool isOwnSkeleton(const BvhMotion& motion);

/// True where the last frame is the first again, one travel on, with the body in motion as in between.
bool isCyclic(const BvhMotion& motion);

/// Adds to a clip the contacts that heights and speeds of its limbs tell, in place of those it has
/// (a foot within 5 cm of the ground and slower than 0.5 m/s, 1 m/s where the clip is fast).
void findContacts(Clip& clip);

}  // namespace muster
