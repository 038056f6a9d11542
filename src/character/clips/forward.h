// Places of a file's joints.
#pragma once

#include <vector>

#include "base/maths.h"
#include "muster/clip.h"

namespace muster {

/// Every joint in the world in one frame; reuses the memory of `joints`.
inline void globalTransforms(const BvhMotion& motion, std::size_t frame, std::vector<Transform>& joints) {
    const auto local = motion.frame(frame);
    joints.resize(local.size());
    for (std::size_t j = 0; j < local.size(); ++j) {
        const std::int32_t parent = motion.joints[j].parent;
        joints[j] = parent < 0 ? local[j] : joints[parent] * local[j];
    }
}

/// Every joint in the rest pose, the root where its offset puts it.
inline std::vector<Vec3> restPlaces(std::span<const BvhJoint> joints) {
    std::vector<Vec3> places;
    for (const BvhJoint& joint : joints)
        places.push_back(joint.parent < 0 ? joint.offset : places[joint.parent] + joint.offset);
    return places;
}

/// The way that hips face, by their left [rad].
inline double facingOf(Quat hips) {
    const Vec3 left = rotate(hips, {0.0f, 1.0f, 0.0f});
    return arcTangent2(-left.x, left.y);
}

}  // namespace muster
