#include "muster/clip.h"

namespace muster {

const std::array<Joint, kJointCount>& skeleton() {
    static constexpr std::array<Joint, kJointCount> kSkeleton{{
        {"Hips", -1, {0.0f, 0.0f, 0.95f}, {}},
        {"Spine", 0, {0.0f, 0.0f, 0.10f}, {}},
        {"Chest", 1, {0.0f, 0.0f, 0.17f}, {}},
        {"Neck", 2, {0.0f, 0.0f, 0.25f}, {}},
        {"Head", 3, {0.015f, 0.0f, 0.09f}, {0.0f, 0.0f, 0.19f}},
        {"LeftShoulder", 2, {0.0f, 0.03f, 0.19f}, {}},
        {"LeftArm", 5, {0.0f, 0.15f, 0.0f}, {}},
        {"LeftForeArm", 6, {0.0f, 0.28f, 0.0f}, {}},
        {"LeftHand", 7, {0.0f, 0.25f, 0.0f}, {0.0f, 0.17f, 0.0f}},
        {"RightShoulder", 2, {0.0f, -0.03f, 0.19f}, {}},
        {"RightArm", 9, {0.0f, -0.15f, 0.0f}, {}},
        {"RightForeArm", 10, {0.0f, -0.28f, 0.0f}, {}},
        {"RightHand", 11, {0.0f, -0.25f, 0.0f}, {0.0f, -0.17f, 0.0f}},
        {"LeftUpLeg", 0, {0.0f, 0.09f, -0.04f}, {}},
        {"LeftLeg", 13, {0.0f, 0.0f, -0.42f}, {}},
        {"LeftFoot", 14, {0.0f, 0.0f, -0.41f}, {}},
        {"LeftToeBase", 15, {0.13f, 0.0f, -0.05f}, {0.07f, 0.0f, -0.01f}},
        {"RightUpLeg", 0, {0.0f, -0.09f, -0.04f}, {}},
        {"RightLeg", 17, {0.0f, 0.0f, -0.42f}, {}},
        {"RightFoot", 18, {0.0f, 0.0f, -0.41f}, {}},
        {"RightToeBase", 19, {0.13f, 0.0f, -0.05f}, {0.07f, 0.0f, -0.01f}},
    }};
    return kSkeleton;
}

float characterSize(std::uint32_t id) {
    // The finaliser of MurmurHash3 hashes the id. The page uses the same function.
    std::uint32_t h = id;
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    h ^= h >> 16;
    return 0.96f + 0.08f * static_cast<float>((h >> 16) & 255u) / 255.0f;
}

}  // namespace muster
