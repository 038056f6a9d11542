// Poses of the skeleton.
#pragma once

#include <array>
#include <span>

#include "muster/quat.h"
#include "muster/skeleton.h"

namespace muster {

/// How a body is held, in the character's own frame: on the ground below it, facing +x.
struct BodyPose {
    Vec3 hips;  ///< Where the hips are [m].
    /// Of each joint relative to its parent; of the hips to the character.
    std::array<Quat, kJointCount> rotation;
};

/// The rest pose.
BodyPose restPose();

/// Joints in the character's own frame (or where `root` puts it).
using JointTransforms = std::array<Transform, kJointCount>;

/// Forward kinematics: every joint's place and rotation; `root` puts the character into the world.
void jointTransforms(const BodyPose& pose, const Transform& root, JointTransforms& joints);

/// Between two poses: hips straight, rotations by nlerp; t = 0 gives `a`.
void blend(const BodyPose& a, const BodyPose& b, float t, BodyPose& out);

}  // namespace muster
