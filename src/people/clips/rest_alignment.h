// Aligns Muster's rest pose with the rest pose of another skeleton.
#pragma once

#include <array>

#include "muster/clip.h"
#include "people/clips/joint_roles.h"

namespace muster {

/// For each role, the rotation from the direction of Muster's bone in its rest pose to that of the file's
/// bone in its own rest pose.
using RestAlignment = std::array<Quat, kJointCount>;

/// Aligns limbs by the shortest arc between bone directions and feet by their heading, since soles are flat
/// in rest poses. The trunk is aligned only if it differs by more than physique explains.
RestAlignment restAlignment(const BvhMotion& motion, const RoleJoints& roles);

/// Leg length of Muster's skeleton divided by that of the file, from hip joint to ankle.
float legScale(const BvhMotion& motion, const RoleJoints& roles);

}  // namespace muster
