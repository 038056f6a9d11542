// Which joint of a foreign skeleton plays which part, by its name.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "muster/clip.h"

namespace muster {

/// Index of the joint that plays each role; -1 where none does.
using RoleJoints = std::array<std::int32_t, kJointCount>;

/// Finds roles by the names that CMU's, DeepMimic's, Mixamo's, Biped's, Rokoko's, Blender's and many other
/// skeletons use, and by who is whose child.
RoleJoints findRoles(std::span<const BvhJoint> joints);

/// Fails with Unsupported, naming what is missing, where hips and legs to the feet are not all there.
Status hasBody(const RoleJoints& roles);

}  // namespace muster
