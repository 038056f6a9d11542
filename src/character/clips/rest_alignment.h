// How another skeleton's rest pose differs from ours.
#pragma once

#include <array>

#include "character/clips/joint_roles.h"
#include "muster/clip.h"

namespace muster {

/// For each role, the turn that brings our bone from our rest pose to where the file's bone lies in its own.
using RestAlignment = std::array<Quat, kJointCount>;

/// Limbs by the shortest arc between bone directions; the trunk only where it lies quite otherwise, as backs
/// lean by build; feet by their heading, as soles lie flat in rest poses.
RestAlignment restAlignment(const BvhMotion& motion, const RoleJoints& roles);

/// Our length of leg over theirs, hip joint to ankle.
float legScale(const BvhMotion& motion, const RoleJoints& roles);

}  // namespace muster
