// Identifies the joints of a foreign skeleton by name and hierarchy.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "muster/clip.h"

namespace muster {

/// Index of the joint in each role; -1 for none.
using RoleJoints = std::array<std::int32_t, kJointCount>;

/// Finds roles by the joint names of CMU, DeepMimic, Mixamo, Biped, Rokoko, Blender and many other skeletons,
/// and by the hierarchy.
RoleJoints findRoles(std::span<const BvhJoint> joints);

/// Fails with Unsupported if hips, legs or feet are missing; the message names the missing joints.
Status hasBody(const RoleJoints& roles);

}  // namespace muster
