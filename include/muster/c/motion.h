/* Made by schema/generate.mjs from schema/api/motion.txt: change these, not this file. */
/* Animation of a crowd: which clip each character plays, and its pose with feet on the floor. It reads
 * worlds and never changes them. Component motion. */
#ifndef MUSTER_C_MOTION_H
#define MUSTER_C_MOTION_H

#include "muster/c/clips.h"
#include "muster/c/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The clip that a character plays: enough to draw it from baked poses.
typedef struct MusterMotionState {
    uint16_t clip;        ///< Index into the library.
    uint16_t fromClip;    ///< The clip that fades out.
    float time;           ///< Time in `clip` [s], within one play.
    float fromTime;       ///< Time in `fromClip` [s].
    float fade;           ///< Share of `fromClip` still shown, 0 to 1.
    MusterVec2 position;  ///< Origin of the body axes in the world: the simulated position [m].
    float yaw;            ///< Heading, counter-clockwise from +x [rad].
    float size;           ///< Factor of the skeleton: muster_character_size() of its id.
} MusterMotionState;

/// The motion of all characters of a world.
typedef struct MusterMotionId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterMotionId;

/// The motion of a crowd at one moment.
typedef struct MusterMotionMomentId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterMotionMomentId;

/// Motion by the clips of a library; by an empty one all characters are shown in the rest pose. `allNear`:
/// all characters get whole poses until muster_motion_set_near() is called, else none does.
MUSTER_API MusterStatus muster_motion_create(MusterClipLibraryId library, bool allNear,
                                             MusterMotionId* outMotion);
/// Ends a motion. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_motion_destroy(MusterMotionId motion);
/// Forgets all characters; the next update starts their motion again.
MUSTER_API MusterStatus muster_motion_restart(MusterMotionId motion);
/// Call after every step of the world. The motion of new characters, and of those that were moved by a
/// command, starts again.
MUSTER_API MusterStatus muster_motion_update(MusterMotionId motion, MusterWorldId world);

/// Ids of the characters that get whole poses from the next update on, in any order; unknown ids are ignored.
MUSTER_API MusterStatus muster_motion_set_near(MusterMotionId motion, const MusterCharacterId* ids,
                                               int32_t idCount);
/// The clip and time of each character, in the world's order. Valid until the next update.
MUSTER_API MusterStatus muster_motion_states(MusterMotionId motion, const MusterMotionState** outStates,
                                             int32_t* outCount);
/// Indices of characters with whole poses, ascending. Valid until the next update.
MUSTER_API MusterStatus muster_motion_near(MusterMotionId motion, const uint32_t** outIndices,
                                           int32_t* outCount);
/// The pose of the k-th of muster_motion_near(), with locked feet, for a body of size 1. In the world it is
/// scaled by `size`, rotated by `yaw` and moved to `position`. Fails with InvalidArgument for other k.
MUSTER_API MusterStatus muster_motion_pose(MusterMotionId motion, int32_t k, MusterBodyPose* outPose);
/// The id of the k-th of muster_motion_near().
MUSTER_API MusterStatus muster_motion_near_id(MusterMotionId motion, int32_t k,
                                              MusterCharacterId* outCharacter);
/// True while that limb of the k-th of muster_motion_near() is locked in a contact.
MUSTER_API MusterStatus muster_motion_locked(MusterMotionId motion, int32_t k, MusterLimb limb,
                                             bool* outLocked);
/// The joints of the k-th of muster_motion_near() in the world [m]: writes MUSTER_JOINT_COUNT transforms.
MUSTER_API MusterStatus muster_motion_joints(MusterMotionId motion, int32_t k, MusterTransform* outJoints);

/// All that later motion depends on, to go back to together with a snapshot of the world.
MUSTER_API MusterStatus muster_motion_moment(MusterMotionId motion, MusterMotionMomentId* outMoment);
/// Goes back, or on, to a moment of a motion by the same library. Fails with InvalidArgument for another.
MUSTER_API MusterStatus muster_motion_go_back(MusterMotionId motion, MusterMotionMomentId moment);
/// The memory of a moment [bytes].
MUSTER_API MusterStatus muster_motion_moment_size(MusterMotionMomentId moment, size_t* outBytes);
/// Ends a moment. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_motion_moment_destroy(MusterMotionMomentId moment);

#ifdef __cplusplus
}
#endif

#endif
