// The clip libraries of a C program.
#pragma once

#include <memory>

#include "bindings/c/c_motion/generated/struct_versions.h"
#include "bindings/c/c_world/marshal.h"
#include "muster/clip.h"
#include "muster/muster.h"

namespace muster::c_api {

/// A library and its C structs; motions that play its clips share it.
struct LibraryThing {
    std::shared_ptr<const ClipLibrary> clips;
    Arena arena;
    const MusterClip* written = nullptr;
    std::int32_t count = 0;
};

/// The library of that handle; NotFound where there is none.
Result<LibraryThing*> findLibrary(MusterClipLibraryId id);

/// The length of an array that MusterBodyPose holds.
static_assert(kJointCount == MUSTER_JOINT_COUNT &&
              sizeof(MusterBodyPose::rotation) / sizeof(MusterQuat) == kJointCount);
static_assert(sizeof(MusterTransform) == sizeof(Transform) &&
              offsetof(MusterTransform, translation) == offsetof(Transform, translation));
static_assert(sizeof(MusterBodyPose) == sizeof(BodyPose) &&
              offsetof(MusterBodyPose, rotation) == offsetof(BodyPose, rotation));

/// The same pose in C.
inline MusterBodyPose poseOf(const BodyPose& pose) {
    MusterBodyPose same;
    std::memcpy(&same, &pose, sizeof(same));
    return same;
}
/// The same pose in the engine.
inline BodyPose poseOf(const MusterBodyPose& pose) {
    BodyPose same;
    std::memcpy(static_cast<void*>(&same), &pose, sizeof(same));
    return same;
}
/// Writes all joints.
inline void giveJoints(const JointTransforms& joints, MusterTransform* out) {
    std::memcpy(out, joints.data(), sizeof(Transform) * joints.size());
}

}  // namespace muster::c_api
