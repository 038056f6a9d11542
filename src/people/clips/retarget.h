// Retargets motions of other skeletons to Muster's skeleton: finds the joints of the other one, and aligns
// the rest poses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "muster/clip.h"

namespace muster {

/// Index of the joint in each role; -1 for none.
using RoleJoints = std::array<std::int32_t, kJointCount>;

/// Finds roles by the joint names of CMU, DeepMimic, Mixamo, Biped, Rokoko, Blender and many other skeletons,
/// and by the hierarchy.
RoleJoints findRoles(std::span<const BvhJoint> joints);

/// Fails with Unsupported if hips, legs or feet are missing; the message names the missing joints.
Status hasBody(const RoleJoints& roles);

/// For each role, the rotation from the direction of Muster's bone in its rest pose to that of the file's
/// bone in its own rest pose.
using RestAlignment = std::array<Quat, kJointCount>;

/// Aligns limbs by the shortest arc between bone directions and feet by their heading, since soles are flat
/// in rest poses. The trunk is aligned only if it differs by more than physique explains.
RestAlignment restAlignment(const BvhMotion& motion, const RoleJoints& roles);

/// Leg length of Muster's skeleton divided by that of the file, from hip joint to ankle.
float legScale(const BvhMotion& motion, const RoleJoints& roles);

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
