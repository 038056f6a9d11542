// The skeleton of Muster's own characters.
//
// Every clip at run time stands on this skeleton; motion of other skeletons (BVH) is brought onto it by role.
// In the rest pose the character stands at the origin facing +x, arms out to the sides, and every joint's
// frame is parallel to the character's own (x forward, y left, z up).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "muster/vec3.h"

namespace muster {

/// The joints, parents before children. The values are indices into every array of joints.
enum class JointRole : std::uint8_t {
    Hips,
    Spine,
    Chest,
    Neck,
    Head,
    LeftShoulder,
    LeftArm,
    LeftForeArm,
    LeftHand,
    RightShoulder,
    RightArm,
    RightForeArm,
    RightHand,
    LeftUpLeg,
    LeftLeg,
    LeftFoot,
    LeftToeBase,
    RightUpLeg,
    RightLeg,
    RightFoot,
    RightToeBase,
    Count
};

inline constexpr std::size_t kJointCount = static_cast<std::size_t>(JointRole::Count);  ///< 21.
constexpr std::size_t index(JointRole role) {
    return static_cast<std::size_t>(role);
}

/// A joint in the rest pose.
struct Joint {
    const char* name;     ///< As many animation programs call it: "LeftForeArm".
    std::int32_t parent;  ///< -1 for the hips.
    Vec3 offset;          ///< From the parent [m]; of the hips from the ground below.
    Vec3 tip;             ///< Where the bone of a joint without children ends, from the joint [m]; else zero.
};

/// The skeleton of a person 1.75 m tall.
const std::array<Joint, kJointCount>& skeleton();

inline constexpr float kBodyHeight = 1.75f;  ///< Top of the head in the rest pose [m].

/// Size of the character with that id: 0.96 to 1.04 of the skeleton, even over the crowd.
float characterSize(std::uint32_t id);

}  // namespace muster
