#include "muster/clip.h"

namespace muster {

BodyPose restPose() {
    BodyPose pose;
    pose.hips = skeleton()[0].offset;
    return pose;
}

void jointTransforms(const BodyPose& pose, const Transform& root, JointTransforms& joints) {
    const auto& bones = skeleton();
    joints[0] = root * Transform{pose.rotation[0], pose.hips};
    for (std::size_t j = 1; j < kJointCount; ++j)
        joints[j] = joints[bones[j].parent] * Transform{pose.rotation[j], bones[j].offset};
}

void blend(const BodyPose& a, const BodyPose& b, float t, BodyPose& out) {
    out.hips = lerp(a.hips, b.hips, t);
    for (std::size_t j = 0; j < kJointCount; ++j) out.rotation[j] = nlerp(a.rotation[j], b.rotation[j], t);
}

}  // namespace muster
