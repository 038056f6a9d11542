// Forward kinematics of a BVH motion.
#pragma once

#include <vector>

#include "base/maths.h"
#include "muster/clip.h"

namespace muster {

/// Computes the global transform of every joint in one frame; reuses the memory of `joints`.
inline void globalTransforms(const BvhMotion& motion, std::size_t frame, std::vector<Transform>& joints) {
    const auto local = motion.frame(frame);
    joints.resize(local.size());
    for (std::size_t j = 0; j < local.size(); ++j) {
        const std::int32_t parent = motion.joints[j].parent;
        joints[j] = parent < 0 ? local[j] : joints[parent] * local[j];
    }
}

/// Positions of all joints in the rest pose, with the root at its offset.
inline std::vector<Vec3> restPositions(std::span<const BvhJoint> joints) {
    std::vector<Vec3> positions;
    for (const BvhJoint& joint : joints)
        positions.push_back(joint.parent < 0 ? joint.offset : positions[joint.parent] + joint.offset);
    return positions;
}

/// Yaw in which the hips face, from their left axis [rad].
inline double facingOf(Quat hips) {
    const Vec3 left = rotate(hips, {0.0f, 1.0f, 0.0f});
    return arcTangent2(-left.x, left.y);
}

}  // namespace muster
