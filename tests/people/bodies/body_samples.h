// Bodies and poses that the tests share.
#pragma once

#include <string>
#include <vector>

#include "base/maths.h"
#include "people/bodies/body_mesh.h"

namespace muster::testing {

/// A body at a level.
struct Sample {
    std::string name;
    BodyKind kind;
    BodyLevel level;
    bool near;
    BodyMesh mesh;
};

/// All of them.
inline const std::vector<Sample>& samples() {
    static const std::vector<Sample> kSamples = [] {
        std::vector<Sample> all;
        for (const BodyKind kind : {BodyKind::Broad, BodyKind::Narrow})
            for (const BodyLevel level : {BodyLevel::Near, BodyLevel::Far}) {
                const bool near = level == BodyLevel::Near;
                all.push_back(
                    {std::string(kind == BodyKind::Broad ? "broad" : "narrow") + (near ? "" : ", far"), kind,
                     level, near, makeBody(kind, level)});
            }
        return all;
    }();
    return kSamples;
}

/// The rest pose with one joint turned by degrees.
inline BodyPose bent(JointRole role, Vec3 axis, double degrees) {
    BodyPose pose = restPose();
    pose.rotation[index(role)] = axisAngle(axis, degrees * kPi / 180.0);
    return pose;
}

/// Poses near the ends of what joints can do: arms down, up and forward, crouched, stepping high.
inline std::vector<BodyPose> hardPoses() {
    const auto turn = [](BodyPose& pose, JointRole role, Vec3 axis, double degrees) {
        pose.rotation[index(role)] = axisAngle(axis, degrees * kPi / 180.0);
    };
    std::vector<BodyPose> poses(3, restPose());
    turn(poses[0], JointRole::LeftArm, {-1.0f, 0.0f, 0.0f}, 85.0);
    turn(poses[0], JointRole::RightArm, {0.0f, 0.0f, 1.0f}, 90.0);
    turn(poses[0], JointRole::RightForeArm, {0.0f, 0.0f, 1.0f}, 130.0);
    turn(poses[1], JointRole::LeftArm, {1.0f, 0.0f, 0.0f}, 80.0);
    for (const JointRole thigh : {JointRole::LeftUpLeg, JointRole::RightUpLeg})
        turn(poses[1], thigh, {0.0f, -1.0f, 0.0f}, 110.0);
    for (const JointRole shin : {JointRole::LeftLeg, JointRole::RightLeg})
        turn(poses[1], shin, {0.0f, 1.0f, 0.0f}, 130.0);
    turn(poses[2], JointRole::LeftUpLeg, {0.0f, -1.0f, 0.0f}, 95.0);
    turn(poses[2], JointRole::RightUpLeg, {0.0f, 1.0f, 0.0f}, 30.0);
    turn(poses[2], JointRole::Spine, {0.0f, 1.0f, 0.0f}, 35.0);
    turn(poses[2], JointRole::Head, {0.0f, 0.0f, 1.0f}, 60.0);
    return poses;
}

}  // namespace muster::testing
